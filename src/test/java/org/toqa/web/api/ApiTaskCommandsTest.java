package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
  void aLoadThatWasLeftIsSaidToBeGoneOnce() {
    long task = add(token);
    String path = "api/v1/tasks/" + task;
    assertEquals(409, post(token, path + "/load-removed", "").statusCode());
    server.fleet().changeTask(task, TaskState.CARRYING, List.of("r1"), "picked up");
    server.fleet().loseRobotOf(task);
    post(token, path + "/answer", "{\"answer\":\"cancel\"}");
    assertEquals("CANCELLED", JSON.readTree(get(path).body()).get("state").stringValue());
    assertEquals(2, JSON.readTree(get(path).body()).get("loadAt").get("x").doubleValue());

    HttpResponse<String> gone = post(token, path + "/load-removed", "");

    assertEquals(200, gone.statusCode(), gone.body());
    assertTrue(JSON.readTree(gone.body()).get("loadAt").isNull());
    assertEquals(409, post(token, path + "/load-removed", "").statusCode());
  }
}
