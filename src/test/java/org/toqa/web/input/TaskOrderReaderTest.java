package org.toqa.web.input;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.mission.TransportTask;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/** One order by a form, as JSON and in a table: it becomes the same task. */
class TaskOrderReaderTest {
  private static WebTestServer server;
  private static TestClient clerk;

  private long before;

  /** What the order says of a task. */
  private record Ordered(
      String name,
      double load,
      Object start,
      Object goal,
      String floor,
      int priority,
      @Nullable Instant deadline,
      @Nullable Object size) {
    static Ordered of(TransportTask task) {
      return new Ordered(
          task.name(),
          task.load(),
          task.start(),
          task.goal(),
          task.floor(),
          task.priority(),
          task.deadline(),
          task.size());
    }
  }

  @BeforeAll
  static void start() throws Exception {
    server = WebTestServer.start();
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
  }

  @AfterAll
  static void stop() throws Exception {
    clerk.close();
    server.close();
  }

  @BeforeEach
  void count() {
    before = server.fleet().count();
  }

  @Test
  void aFullOrderIsTheSameFromEveryInput() {
    HttpResponse<String> form =
        clerk.post(
            "tasks/new",
            Map.ofEntries(
                Map.entry("name", "Box of bolts"),
                Map.entry("load", "2.5"),
                Map.entry("startStation", "Dock A"),
                Map.entry("goalX", "10.35"),
                Map.entry("goalY", "1.05"),
                Map.entry("floor", "hall"),
                Map.entry("priority", "7"),
                Map.entry("deadline", "2098-07-01T15:00"),
                Map.entry("zone", "Europe/Paris"),
                Map.entry("length", "1.2"),
                Map.entry("width", "0.8")));
    HttpResponse<String> json =
        clerk.postJson(
            "api/v1/tasks",
            """
            {"name": "Box of bolts", "load": 2.5, "start": {"station": "Dock A"},
             "goal": {"x": 10.35, "y": 1.05}, "floor": "hall", "priority": 7,
             "deadline": "2098-07-01T15:00:00+02:00", "size": {"length": 1.2, "width": 0.8}}
            """);
    HttpResponse<String> table =
        postTable(
            """
            name,load,start,goalX,goalY,floor,priority,deadline,length,width
            Box of bolts,2.5,Dock A,10.35,1.05,hall,7,2098-07-01 15:00,1.2,0.8
            """);

    assertSame(form, json, table);
  }

  @Test
  void anOrderOfWhatMustBeThereIsTheSameFromEveryInput() {
    HttpResponse<String> form =
        clerk.post(
            "tasks/new",
            Map.of(
                "name", "nuts", "load", "1", "startStation", "Dock A", "goalStation", "Shelf 3"));
    HttpResponse<String> json =
        clerk.postJson(
            "api/v1/tasks",
            """
            {"name": "nuts", "load": 1, "start": {"station": "Dock A"},
             "goal": {"station": "Shelf 3"}}
            """);
    HttpResponse<String> table = postTable("name,load,start,goal\nnuts,1,Dock A,Shelf 3\n");

    assertSame(form, json, table);
  }

  private void assertSame(
      HttpResponse<String> form, HttpResponse<String> json, HttpResponse<String> table) {
    assertEquals(303, form.statusCode(), form.body());
    assertEquals(201, json.statusCode(), json.body());
    assertEquals(201, table.statusCode(), table.body());
    Ordered first = ordered(1);
    assertEquals(List.of(first, first), List.of(ordered(2), ordered(3)));
  }

  private Ordered ordered(int number) {
    return Ordered.of(server.fleet().task(before + number).orElseThrow().task());
  }

  private static HttpResponse<String> postTable(String table) {
    return clerk.send(
        clerk
            .request("api/v1/tasks/import?zone=Europe/Paris")
            .header("Content-Type", "text/csv")
            .header("X-CSRF-Token", clerk.csrf())
            .POST(BodyPublishers.ofString(table))
            .build());
  }
}
