package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.mission.TaskState;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;

/** Orders that are carried as several tasks, through the API. */
class ApiOrdersTest extends ApiTestServer {
  private static final String PIECES = GOOD_TASK.replace("\"load\"", "\"pieces\": 3, \"load\"");
  private static final String STOPS =
      """
      {"name": "Tour", "load": 1, "stops":
        [{"station": "Dock A"}, {"x": 10.35, "y": 1.05}, {"station": "Dock A"}]}
      """;

  @Test
  void anOrderOfPiecesIsStoredWholeAndShowsOneProgress() {
    HttpResponse<String> answer = post(token, "api/v1/orders", PIECES);

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode order = JSON.readTree(answer.body());
    String path = "api/v1/orders/" + order.get("id").asLong();
    assertEquals("/" + path, answer.headers().firstValue("Location").orElseThrow());
    assertEquals("PIECES QUEUED 0 of 3", summary(order));
    assertEquals(3, order.get("tasks").size());
    JsonNode second = JSON.readTree(get("api/v1/tasks/2").body()).get("order");
    assertEquals("2 of 3", second.get("part") + " of " + second.get("parts"));
    assertTrue(JSON.readTree(get("api/v1/tasks/" + add(token)).body()).get("order").isNull());

    server.fleet().changeTask(1, TaskState.RETURNING, List.of("r1"), "It is there.");
    assertEquals("PIECES IN_PROGRESS 1 of 3", summary(JSON.readTree(get(path).body())));
    JsonNode listed = JSON.readTree(get("api/v1/orders").body()).get(0);
    assertEquals("PIECES IN_PROGRESS 1 of 3", summary(listed));
    assertFalse(listed.has("tasks"));
    for (long task = 1; task <= 3; task++) {
      server.fleet().changeTask(task, TaskState.DONE, List.of("r1"), "r1 has parked.");
    }
    assertEquals("PIECES DONE 3 of 3", summary(JSON.readTree(get(path).body())));
  }

  @Test
  void aCancelledLegStopsTheRestUntilItIsOrderedAgain() {
    JsonNode order = JSON.readTree(post(token, "api/v1/orders", STOPS).body());
    assertEquals("STOPS QUEUED 0 of 2", summary(order));
    String path = "api/v1/orders/" + order.get("id").asLong();
    assertEquals(409, post(token, path + "/retry", "").statusCode());
    server.fleet().changeTask(1, TaskState.CANCELLED, List.of(), "It was cancelled.");

    JsonNode stopped = JSON.readTree(get(path).body());
    assertEquals("STOPS STOPPED 0 of 2", summary(stopped));
    assertEquals(2, stopped.get("stuck").get(0).get("task").asInt());
    assertTrue(
        stopped.get("stuck").get(0).get("why").stringValue().contains("ended without delivery"));

    JsonNode again = JSON.readTree(post(token, path + "/retry", "").body());

    assertEquals("STOPS QUEUED 0 of 2", summary(again));
    assertEquals(
        "3 2", again.get("tasks").get(0).get("id") + " " + again.get("tasks").get(1).get("id"));
    assertEquals(409, post(token, path + "/retry", "").statusCode());
  }

  @Test
  void anOrderIsCancelledByWhoseItIsAndAsksWhereLoadsOnBoardGo() {
    String clerk = tokenOf(WebTestServer.CLERK);
    String others = "api/v1/orders/" + id(post(token, "api/v1/orders", PIECES));
    assertEquals(403, post(clerk, others + "/cancel", "").statusCode());
    assertEquals(403, post(clerk, others + "/retry", "").statusCode());
    assertEquals(404, post(token, "api/v1/orders/999/cancel", "").statusCode());
    String own = "api/v1/orders/" + id(post(clerk, "api/v1/orders", PIECES));
    server.fleet().changeTask(4, TaskState.DONE, List.of("r1"), "r1 has parked.");
    server.fleet().changeTask(6, TaskState.CARRYING, List.of("r1"), "r1 carries it.");

    HttpResponse<String> asked = post(clerk, own + "/cancel", "");
    assertEquals(409, asked.statusCode());
    assertEquals(
        "[\"here\",\"back\"]", JSON.readTree(asked.body()).at("/needs/answers").toString());
    assertEquals("PIECES IN_PROGRESS 1 of 3", summary(JSON.readTree(get(own).body())));
    assertEquals(422, post(clerk, own + "/cancel", "{\"load\":\"away\"}").statusCode());

    HttpResponse<String> cancelled = post(clerk, own + "/cancel", "{\"load\":\"here\"}");
    assertEquals(200, cancelled.statusCode(), cancelled.body());
    assertEquals(
        TaskState.CANCELLED, server.fleet().task(5).orElseThrow().state(), "it was not begun");
    assertEquals(200, post(token, others + "/cancel", "").statusCode());
    assertEquals("PIECES CANCELLED 0 of 3", summary(JSON.readTree(get(others).body())));
  }

  @Test
  void allOfAnOrderIsHeldAndGoesOnAndIsGivenAPriorityAtOnce() {
    String clerk = tokenOf(WebTestServer.CLERK);
    String others = "api/v1/orders/" + id(post(token, "api/v1/orders", PIECES));
    for (String command : List.of("/hold", "/resume", "/priority")) {
      assertEquals(403, post(clerk, others + command, "{\"priority\":1}").statusCode(), command);
      assertEquals(
          404, post(token, "api/v1/orders/999" + command, "{\"priority\":1}").statusCode());
    }
    String own = "api/v1/orders/" + id(post(clerk, "api/v1/orders", PIECES));
    server.fleet().changeTask(4, TaskState.DONE, List.of("r1"), "r1 has parked.");
    server.fleet().changeTask(5, TaskState.CARRYING, List.of("r1"), "r1 carries it.");

    JsonNode held = JSON.readTree(post(clerk, own + "/hold", "").body());
    assertEquals("2 of 3 on hold", held.get("held") + " of " + held.get("parts") + " on hold");
    assertTrue(server.fleet().task(5).orElseThrow().held());
    assertFalse(server.fleet().task(4).orElseThrow().held(), "it has ended");
    assertFalse(server.fleet().task(1).orElseThrow().held(), "it is of another order");

    HttpResponse<String> first = post(clerk, own + "/priority", "{\"priority\":10}");
    assertEquals(200, first.statusCode(), first.body());
    assertEquals(10, server.fleet().task(6).orElseThrow().task().priority());
    assertEquals(0, server.fleet().task(4).orElseThrow().task().priority());
    assertEquals(422, post(clerk, own + "/priority", "{\"priority\":101}").statusCode());
    assertEquals(422, post(clerk, own + "/priority", "{\"rank\":1}").statusCode());

    assertEquals(0, JSON.readTree(post(clerk, own + "/resume", "").body()).get("held").asInt());
    assertFalse(server.fleet().task(6).orElseThrow().held());
    server.fleet().changeTask(5, TaskState.DONE, List.of("r1"), "r1 has parked.");
    server.fleet().changeTask(6, TaskState.DONE, List.of("r1"), "r1 has parked.");
    assertEquals(409, post(clerk, own + "/hold", "").statusCode());
  }

  @Test
  void anOrderThatComesAgainWithItsKeyIsThereOnce() {
    JsonNode first = JSON.readTree(withKey(PIECES).body());
    JsonNode again = JSON.readTree(withKey(PIECES).body());

    assertEquals(first.get("id"), again.get("id"));
    assertEquals(3, server.fleet().count());
    assertEquals(422, withKey(STOPS).statusCode());
    assertEquals(422, withKey(PIECES.replace("3,", "2,")).statusCode());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"pieces\":0,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"x\":10.35,\"y\":1.05}|pieces",
        "\"pieces\":101,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"x\":10.35,\"y\":1.05}|pieces",
        "\"pieces\":1.5,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"x\":10.35,\"y\":1.05}|pieces",
        "\"pieces\":2,\"start\":{\"station\":\"Dock A\"}|goal",
        "\"stops\":[{\"station\":\"Dock A\"}]|stops",
        "\"stops\":\"Dock A\"|stops",
        "\"stops\":[1,2]|stops",
        "\"stops\":[{\"station\":\"Dock A\"},{\"x\":1}]|stops.1.y",
        "\"stops\":[{\"station\":\"Dock A\"},{\"station\":\"Nowhere\"}]|stops.1",
        "\"stops\":[{\"station\":\"Dock A\"},{\"x\":10.35,\"y\":1.05}],\"pieces\":2|pieces",
        "\"stops\":[{\"station\":\"Dock A\"},{\"x\":10.35,\"y\":1.05}],\"goal\":null|goal"
      })
  void whatIsWrongIsToldUnderItsField(String places, String field) {
    HttpResponse<String> answer =
        post(token, "api/v1/orders", "{\"name\":\"x\",\"load\":1," + places + "}");

    assertEquals(422, answer.statusCode(), answer.body());
    assertEquals(
        field, JSON.readTree(answer.body()).get("errors").get(0).get("field").stringValue());
    assertEquals(0, server.fleet().count());
  }

  private HttpResponse<String> withKey(String order) {
    return visitor.send(
        visitor
            .request("api/v1/orders")
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "application/json")
            .header("Idempotency-Key", "k1")
            .POST(BodyPublishers.ofString(order))
            .build());
  }

  private static long id(HttpResponse<String> answer) {
    return JSON.readTree(answer.body()).get("id").asLong();
  }

  private static String summary(JsonNode order) {
    return "%s %s %s of %s"
        .formatted(
            order.get("kind").stringValue(),
            order.get("state").stringValue(),
            order.get("delivered"),
            order.get("parts"));
  }
}
