package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.mission.TaskState;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;

/** Tasks that are changed, held, cancelled and answered through the API. */
class ApiTaskCommandsTest extends ApiTestServer {
  @Test
  void aTasksPriorityIsChangedByItsOwnerOrAManager() throws Exception {
    String clerk = tokenOf(WebTestServer.CLERK);
    post(token, "api/v1/tasks", GOOD_TASK);
    post(clerk, "api/v1/tasks", GOOD_TASK);

    HttpResponse<String> changed = post(clerk, "api/v1/tasks/2/priority", "{\"priority\":7}");

    assertEquals(200, changed.statusCode(), changed.body());
    assertEquals(7, JSON.readTree(changed.body()).get("priority").asInt());
    assertEquals(200, post(token, "api/v1/tasks/2/priority", "{\"priority\":-100}").statusCode());
    assertEquals(403, post(clerk, "api/v1/tasks/1/priority", "{\"priority\":7}").statusCode());
    for (String wrong : List.of("{}", "{\"priority\":1.5}", "{\"priority\":101}", "{\"x\":1}")) {
      assertEquals(422, post(token, "api/v1/tasks/1/priority", wrong).statusCode(), wrong);
    }
    server.fleet().changeTask(1, TaskState.DONE, List.of("r1"), "r1 has parked.");
    assertEquals(409, post(token, "api/v1/tasks/1/priority", "{\"priority\":1}").statusCode());
  }

  @ParameterizedTest
  @ValueSource(strings = {"cancel", "hold", "resume", "answer"})
  void aTaskIsChangedByItsOwnerAndByManagersOnly(String command) {
    long others = add(token);
    String body = command.equals("answer") ? "{\"answer\":\"wait\"}" : "";
    String clerk = tokenOf(WebTestServer.CLERK);

    HttpResponse<String> ofClerk = post(clerk, "api/v1/tasks/" + others + "/" + command, body);

    assertEquals(403, ofClerk.statusCode());
    assertTrue(detail(ofClerk).startsWith("This task belongs to another user."));
    assertEquals(401, post(null, "api/v1/tasks/" + others + "/" + command, body).statusCode());
    assertEquals(404, post(token, "api/v1/tasks/999/" + command, body).statusCode());
    assertEquals(404, post(token, "api/v1/tasks/x/" + command, body).statusCode());
    assertEquals(405, get("api/v1/tasks/" + others + "/" + command).statusCode());
    int expected = command.equals("answer") ? 409 : 200; // it asks nothing
    long own = add(clerk);
    assertEquals(expected, post(clerk, "api/v1/tasks/" + own + "/" + command, body).statusCode());
    assertEquals(expected, post(token, "api/v1/tasks/" + own + "/" + command, body).statusCode());
  }

  @Test
  void aTaskIsHeldAndLetGoOnAndCancelled() {
    String path = "api/v1/tasks/" + add(token);

    assertTrue(JSON.readTree(post(token, path + "/hold", "").body()).get("held").asBoolean());
    assertFalse(JSON.readTree(post(token, path + "/resume", "").body()).get("held").asBoolean());
    HttpResponse<String> cancelled = post(token, path + "/cancel", "{}");
    assertEquals("CANCELLED", JSON.readTree(cancelled.body()).get("state").stringValue());
    HttpResponse<String> tooLate = post(token, path + "/hold", "");
    assertEquals(409, tooLate.statusCode());
    assertTrue(detail(tooLate).endsWith("has ended and can no longer be changed."));
  }

  @Test
  void cancelWithTheLoadOnBoardAsksWhatBecomesOfIt() {
    long task = add(token);
    String path = "api/v1/tasks/" + task + "/cancel";
    server.fleet().changeTask(task, TaskState.CARRYING, List.of("r1"), "picked up");

    HttpResponse<String> asked = post(token, path, "");

    assertEquals(409, asked.statusCode());
    JsonNode needs = JSON.readTree(asked.body()).get("needs");
    assertEquals("[\"here\",\"back\"]", needs.get("answers").toString());
    assertTrue(needs.get("question").stringValue().startsWith("The load is on board."));
    assertEquals(422, post(token, path, "{\"load\":\"away\"}").statusCode());
    assertEquals(422, post(token, path, "{\"lead\":\"back\"}").statusCode());
    assertEquals(400, post(token, path, "[]").statusCode());
    assertEquals(200, post(token, path, "{\"load\":\"back\"}").statusCode());
  }

  @Test
  void aTaskAsksAndIsAnswered() {
    long task = add(token);
    String path = "api/v1/tasks/" + task;
    server.fleet().changeTask(task, TaskState.CARRYING, List.of("r1"), "picked up");
    server.fleet().loseRobotOf(task);

    JsonNode asked = JSON.readTree(get(path).body());
    assertEquals(
        "[\"another robot\",\"wait\",\"cancel\"]", asked.get("needs").get("answers").toString());
    assertEquals(2, asked.get("loadAt").get("x").doubleValue());
    assertEquals(422, post(token, path + "/answer", "{\"answer\":\"perhaps\"}").statusCode());
    assertEquals(422, post(token, path + "/answer", "{}").statusCode());
    HttpResponse<String> answered = post(token, path + "/answer", "{\"answer\":\"another robot\"}");

    assertEquals(200, answered.statusCode());
    JsonNode queued = JSON.readTree(answered.body());
    assertEquals("QUEUED", queued.get("state").stringValue());
    assertTrue(queued.get("needs").isNull());
    assertEquals(2, queued.get("loadAt").get("x").doubleValue());
  }

  @Test
  void cancelWithALostRobotEndsTheTaskOrNamesTheAnswers() {
    long task = add(token);
    String path = "api/v1/tasks/" + task + "/cancel";
    server.fleet().changeTask(task, TaskState.CARRYING, List.of("r1"), "picked up");
    server.fleet().loseRobotOf(task);

    HttpResponse<String> asked = post(token, path, "{\"load\":\"back\"}");
    assertEquals(409, asked.statusCode());
    assertEquals(
        "[\"another robot\",\"wait\",\"cancel\"]",
        JSON.readTree(asked.body()).get("needs").get("answers").toString());
    HttpResponse<String> cancelled = post(token, path, "{\"load\":\"here\"}");
    assertEquals("CANCELLED", JSON.readTree(cancelled.body()).get("state").stringValue());
  }

  @Test
  void loadsAreListedWhereTheyAre() {
    long task = add(token);

    JsonNode waiting = load(task);
    assertEquals("Dock A", waiting.get("place").get("station").stringValue());
    assertTrue(waiting.get("robot").isNull());
    server.fleet().changeTask(task, TaskState.CARRYING, List.of("r1"), "picked up");
    JsonNode carried = load(task);

    assertTrue(carried.get("place").isNull());
    assertEquals("r1", carried.get("robot").stringValue());
    assertEquals(task, carried.get("task").asLong());
  }

  private JsonNode load(long id) {
    for (JsonNode load : JSON.readTree(get("api/v1/loads").body())) {
      if (load.get("id").asLong() == id) {
        return load;
      }
    }
    throw new AssertionError("no load " + id);
  }

  @Test
  void aLoadThatWasLeftIsSaidToBeGoneOnce() {
    long task = add(token);
    String path = "api/v1/tasks/" + task;
    assertEquals(409, post(token, path + "/load-removed", "").statusCode());
    server.fleet().changeTask(task, TaskState.CARRYING, List.of("r1"), "picked up");
    server.fleet().loseRobotOf(task);
    post(token, path + "/answer", "{\"answer\":\"cancel\"}");
    assertEquals("CANCELLED", JSON.readTree(get(path).body()).get("state").stringValue());
    assertEquals(2, JSON.readTree(get(path).body()).get("loadAt").get("x").doubleValue());
    assertEquals(422, post(token, path + "/load-moved", "{}").statusCode());
    assertEquals(
        422, post(token, path + "/load-moved", "{\"place\":{\"station\":\"Moon\"}}").statusCode());
    String there = "{\"place\":{\"x\":3,\"y\":2}}";
    HttpResponse<String> moved = post(token, path + "/load-moved", there);
    assertEquals(3, JSON.readTree(moved.body()).get("loadAt").get("x").doubleValue());

    HttpResponse<String> gone = post(token, path + "/load-removed", "");

    assertEquals(200, gone.statusCode(), gone.body());
    assertTrue(JSON.readTree(gone.body()).get("loadAt").isNull());
    assertEquals(409, post(token, path + "/load-removed", "").statusCode());
  }

  @Test
  void theOrderOfAWaitingTaskIsEditedByWhoHasSeenIt() {
    String path = "api/v1/tasks/" + add(token);
    String seen = get(path).headers().firstValue("ETag").orElseThrow();
    String crate =
        "{\"name\":\"Crate\",\"load\":4,\"start\":{\"station\":\"Shelf 3\"},\"goal\":{\"station\":\"Dock A\"}}";

    HttpResponse<String> edited = edit(path, seen, crate);

    assertEquals(200, edited.statusCode(), edited.body());
    JsonNode task = JSON.readTree(edited.body());
    assertEquals("Crate", task.get("name").stringValue());
    assertEquals("Dock A", task.get("goal").get("station").stringValue());
    assertEquals(412, edit(path, seen, GOOD_TASK).statusCode(), "it is another one by now");
    assertEquals(
        200, edit(path, edited.headers().firstValue("ETag").orElseThrow(), GOOD_TASK).statusCode());
    assertEquals(422, send("PUT", path, "{}").statusCode(), "the whole order");
    assertEquals(422, send("PUT", path, crate.replace("4", "400")).statusCode(), "too heavy");
    assertEquals(404, send("PUT", "api/v1/tasks/999", crate).statusCode());
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "picked up");
    HttpResponse<String> tooLate = send("PUT", path, crate);
    assertEquals(409, tooLate.statusCode());
    assertTrue(detail(tooLate).startsWith("Task 1 is not waiting any more"), detail(tooLate));
  }

  private HttpResponse<String> edit(String path, String version, String order) {
    return visitor.send(
        visitor
            .request(path)
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "application/json")
            .header("If-Match", version)
            .PUT(BodyPublishers.ofString(order))
            .build());
  }

  @Test
  void aTaskIsEditedAndDeletedByItsOwnerAndByManagersOnly() {
    String path = "api/v1/tasks/" + add(token);
    token = tokenOf(WebTestServer.CLERK);

    assertEquals(403, send("PUT", path, GOOD_TASK).statusCode());
    assertEquals(403, send("DELETE", path, "").statusCode());
    String own = "api/v1/tasks/" + add(token);
    assertEquals(200, send("PUT", own, GOOD_TASK).statusCode());
    assertEquals(409, send("DELETE", own, "").statusCode(), "it has not ended");
    post(token, own + "/cancel", "");
    assertEquals(204, send("DELETE", own, "").statusCode());
    assertEquals(404, send("DELETE", own, "").statusCode());
    assertEquals(404, get(own).statusCode());
  }

  @Test
  void everyoneFollowsTasksInAListOfHisOwn() {
    String clerk = tokenOf(WebTestServer.CLERK);
    String path = "api/v1/tasks/" + add(token);
    add(token);

    HttpResponse<String> followed = post(clerk, path + "/follow", "");

    assertEquals(200, followed.statusCode(), followed.body());
    assertTrue(JSON.readTree(followed.body()).get("followed").asBoolean());
    assertEquals(200, post(clerk, path + "/follow", "").statusCode(), "twice is once");
    assertFalse(JSON.readTree(get(path).body()).get("followed").asBoolean(), "not by the manager");
    assertEquals(0, JSON.readTree(get("api/v1/tasks?followed=true").body()).size());
    assertEquals(2, JSON.readTree(get("api/v1/tasks?followed=false").body()).size());
    assertEquals(422, get("api/v1/tasks?followed=perhaps").statusCode());
    token = clerk;
    JsonNode list = JSON.readTree(get("api/v1/tasks?followed=true").body());
    assertEquals(1, list.size());
    assertEquals(1, list.get(0).get("id").longValue());
    assertFalse(
        JSON.readTree(post(clerk, path + "/unfollow", "").body()).get("followed").asBoolean());
    assertEquals(0, JSON.readTree(get("api/v1/tasks?followed=true").body()).size());
  }
}
