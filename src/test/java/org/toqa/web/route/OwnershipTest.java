package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.supervision.SupervisionOrder;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskState;
import org.toqa.testbed.Hall;
import org.toqa.web.FleetAnswers;
import org.toqa.web.TestClient;
import org.toqa.web.WebServerTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Whose tasks, schedules and tokens are, and what becomes of them when their user is deleted. */
class OwnershipTest extends WebServerTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final String ORDER =
      "\"name\":\"box\",\"load\":1,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"x\":9,\"y\":1.05}";
  private static final String SCHEDULE =
      "{\"task\":{" + ORDER + "},\"at\":\"2098-07-01T15:00:00Z\"}";

  @AfterEach
  void forgetCarla() {
    server.forgetWork();
    server
        .accounts()
        .accountByName("Carla")
        .ifPresent(carla -> server.accounts().delete(carla.id(), EventRecord.SYSTEM));
  }

  @Test
  void aNewUserOfADeletedOnesNameInheritsNothing() {
    long task;
    long schedule;
    Account carla = addCarla();
    try (TestClient client = TestClient.signedIn(server.root(), "Carla")) {
      task = addTask(client);
      schedule = addSchedule(client);
      assertEquals(200, client.postJson("api/v1/tasks/" + task + "/hold", "").statusCode());
    }
    HttpResponse<String> deleted =
        delete(carla, "tasks=handOver&schedules=handOver&to=" + account("Max").id());
    assertEquals(204, deleted.statusCode(), deleted.body());

    addCarla();
    try (TestClient client = TestClient.signedIn(server.root(), "Carla")) {
      assertEquals(403, client.postJson("api/v1/tasks/" + task + "/resume", "").statusCode());
      assertEquals(403, client.post("tasks/" + task + "/hold", Map.of()).statusCode());
      assertEquals(403, client.sendJson("DELETE", "api/v1/schedules/" + schedule, "").statusCode());
      assertEquals(403, client.post("schedules/" + schedule + "/pause", Map.of()).statusCode());
    }
    assertEquals("Max", json("api/v1/tasks/" + task).get("user").stringValue());
    assertEquals("Max", json("api/v1/schedules/" + schedule).get("user").stringValue());
    assertFalse(json("api/v1/schedules/" + schedule).get("resting").booleanValue());
  }

  @Test
  void whoDeletesAUserIsAskedWhatBecomesOfHisWork() {
    Account carla = addCarla();
    try (TestClient client = TestClient.signedIn(server.root(), "Carla")) {
      addTask(client);
      addSchedule(client);
    }

    HttpResponse<String> silent = delete(carla, "");
    assertEquals(422, silent.statusCode(), silent.body());
    assertEquals(List.of("tasks", "schedules"), fields(silent));
    assertEquals(List.of("to"), fields(delete(carla, "tasks=handOver&schedules=remove&to=999999")));
    assertEquals(
        List.of("to"),
        fields(delete(carla, "tasks=handOver&schedules=remove&to=" + carla.id())),
        "to himself");
    assertEquals(List.of("tasks"), fields(delete(carla, "tasks=keep&schedules=remove")));
    assertTrue(server.accounts().account(carla.id()).isPresent());
    assertEquals(1, json("api/v1/schedules").size());
  }

  @Test
  void theWorkOfADeletedUserIsCancelledAndRemoved() {
    Account carla = addCarla();
    long queued;
    long carried;
    try (TestClient client = TestClient.signedIn(server.root(), "Carla")) {
      queued = addTask(client);
      carried = addTask(client);
      addSchedule(client);
    }
    server.fleet().changeTask(carried, TaskState.CARRYING, List.of("r1"), "carries");

    assertEquals(List.of("load"), fields(delete(carla, "tasks=cancel&schedules=remove")));
    assertEquals(204, delete(carla, "tasks=cancel&schedules=remove&load=back").statusCode());

    assertEquals("CANCELLED", json("api/v1/tasks/" + queued).get("state").stringValue());
    assertEquals(0, json("api/v1/schedules").size());
    assertTrue(server.accounts().account(carla.id()).isEmpty());
  }

  /** Its tasks would be nobody's, and then those of a new user of that name. */
  @Test
  void whoseSupervisorWorksIsDeletedWhenItIsStopped() throws Exception {
    Account carla = addCarla();
    server
        .fleet()
        .setRobots(
            Hall.withArm(robot("r1", new Pose(1.05, 0.75, 0))),
            Hall.seeing(robot("r3", new Pose(3.45, 0.75, 0))));
    SupervisionOrder order =
        new SupervisionOrder("hall", "r3", List.of("r1"), true, Map.of(1, new Vec2(9, 1.05)));
    FleetAnswers.await(server.supervisor().start(order, "Carla"));

    HttpResponse<String> refused = delete(carla, "");
    assertEquals(409, refused.statusCode(), refused.body());
    assertTrue(refused.body().contains("at work on hall"), refused.body());
    assertFalse(account("Carla").disabled());

    FleetAnswers.await(server.supervisor().stop("hall", "Max"));
    assertEquals(204, delete(carla, "").statusCode());
  }

  @Test
  void thePageAsksToo() {
    Account carla = addCarla();
    long task;
    try (TestClient client = TestClient.signedIn(server.root(), "Carla")) {
      task = addTask(client);
    }
    String page = manager.get("users/" + carla.id()).body();
    assertTrue(page.contains("1 open tasks"), page);
    assertFalse(page.contains("name=\"schedules\""), "there is none");

    HttpResponse<String> silent = manager.post("users/" + carla.id() + "/delete", Map.of());
    assertEquals(422, silent.statusCode());
    assertTrue(silent.body().contains("hand them over or cancel them"), silent.body());
    Map<String, String> choice =
        Map.of("tasks", "handOver", "to", String.valueOf(account("Clara").id()));
    assertEquals(303, manager.post("users/" + carla.id() + "/delete", choice).statusCode());

    assertEquals("Clara", json("api/v1/tasks/" + task).get("user").stringValue());
    assertEquals(200, clerk.postJson("api/v1/tasks/" + task + "/hold", "").statusCode());
  }

  @Test
  void theSchedulesOfADisabledUserRestAndThePageSaysSo() {
    Account carla = addCarla();
    long schedule;
    try (TestClient client = TestClient.signedIn(server.root(), "Carla")) {
      schedule = addSchedule(client);
    }
    assertFalse(clerk.get("schedules").body().contains("Not run while the user is disabled"));

    server.accounts().update(carla.id(), Role.CLERK, true, "Max");

    assertTrue(clerk.get("schedules").body().contains("Not run while the user is disabled"));
    assertTrue(json("api/v1/schedules/" + schedule).get("resting").booleanValue());
  }

  private Account addCarla() {
    server.addUser("Carla", null, Role.CLERK);
    return account("Carla");
  }

  private static RobotView robot(String name, Pose pose) {
    return Hall.robot(name, RobotState.IDLE, pose, "127.0.0.1", 7275);
  }

  private Account account(String name) {
    return server.accounts().accountByName(name).orElseThrow();
  }

  private static long addTask(TestClient client) {
    return created(client.postJson("api/v1/tasks", "{" + ORDER + "}"));
  }

  private static long addSchedule(TestClient client) {
    return created(client.postJson("api/v1/schedules", SCHEDULE));
  }

  private static long created(HttpResponse<String> answer) {
    assertEquals(201, answer.statusCode(), answer.body());
    return JSON.readTree(answer.body()).get("id").longValue();
  }

  private HttpResponse<String> delete(Account user, String query) {
    return manager.sendJson("DELETE", "api/v1/users/" + user.id() + "?" + query, "");
  }

  private JsonNode json(String path) {
    return JSON.readTree(manager.get(path).body());
  }

  private static List<String> fields(HttpResponse<String> answer) {
    assertEquals(422, answer.statusCode(), answer.body());
    return JSON.readTree(answer.body())
        .get("errors")
        .valueStream()
        .map(error -> error.get("field").stringValue())
        .toList();
  }
}
