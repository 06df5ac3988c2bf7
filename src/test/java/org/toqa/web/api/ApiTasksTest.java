package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.ExpectedTimes;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;
import tools.jackson.databind.JsonNode;

/** Tasks that the API takes and lists. */
class ApiTasksTest extends ApiTestServer {
  @Test
  void tasksAreFilteredSortedAndPaged() {
    for (String name : List.of("a", "b", "c")) {
      post(token, "api/v1/tasks", GOOD_TASK.replace(" Box of bolts ", name));
    }
    server.fleet().changeTask(2, TaskState.DONE, List.of("r1"), "r1 has parked.");

    HttpResponse<String> open = get("api/v1/tasks?state=open&sort=id&limit=1&offset=1");

    assertEquals("2", open.headers().firstValue("X-Total-Count").orElseThrow());
    assertEquals("c", JSON.readTree(open.body()).get(0).get("name").stringValue());
    assertEquals(2, JSON.readTree(get("api/v1/tasks?state=DONE").body()).get(0).get("id").asInt());
    HttpResponse<String> misspelt = get("api/v1/tasks?stat=open&limit=1");
    assertEquals(400, misspelt.statusCode());
    assertEquals(
        "There is no parameter stat here. There are floor, followed, from, limit, offset, robot,"
            + " sort, state, text, until, user.",
        detail(misspelt));
    assertEquals(200, get("api/v1/health?at=1764000000").statusCode());
    assertEquals(200, get("api/v1/notices?floor=hall").statusCode());
    HttpResponse<String> wrong = get("api/v1/tasks?state=new&sort=x&until=soon");
    assertEquals(422, wrong.statusCode());
    assertEquals(3, JSON.readTree(wrong.body()).get("errors").size());
  }

  @Test
  void aTaskIsStoredBeforeTheAnswer() {
    HttpResponse<String> answer = post(token, "api/v1/tasks", GOOD_TASK);

    assertEquals(201, answer.statusCode());
    JsonNode task = JSON.readTree(answer.body());
    assertEquals(
        "/api/v1/tasks/" + task.get("id").asLong(),
        answer.headers().firstValue("Location").orElseThrow());
    assertEquals("Box of bolts", task.get("name").stringValue());
    assertEquals("Dock A", task.get("start").get("station").stringValue());
    assertEquals(1.05, task.get("start").get("x").doubleValue());
    assertEquals("QUEUED", task.get("state").stringValue());
    assertEquals("Max", task.get("user").stringValue());
    assertTrue(server.fleet().task(task.get("id").asLong()).isPresent());
  }

  @Test
  void aTaskSaysWhichRobotsAloneMayDoIt() {
    HttpResponse<String> answer =
        post(
            token,
            "api/v1/tasks",
            GOOD_TASK.replaceFirst("\\{", "{\"onlyRobots\":[\"r2\",\"r1\",\"r2\"],"));

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode robots = JSON.readTree(answer.body()).get("onlyRobots");
    assertEquals(List.of("r2", "r1"), robots.values().stream().map(JsonNode::stringValue).toList());
  }

  @Test
  void aTaskIsForRobotsThatCanDoSomething() {
    HttpResponse<String> answer =
        post(
            token,
            "api/v1/tasks",
            GOOD_TASK.replaceFirst("\\{", "{\"onlyRobots\":[\"with:omni\",\"with:arm\"],"));

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode robots = JSON.readTree(answer.body()).get("onlyRobots");
    assertEquals(
        List.of("with:omni", "with:arm"),
        robots.values().stream().map(JsonNode::stringValue).toList());
  }

  @Test
  void aTaskOfSeveralStopsSaysHowFarItIs() {
    String stops =
        "[{\"station\":\"Dock A\"},{\"x\":2,\"y\":1,\"waitForPerson\":true},"
            + "{\"station\":\"Shelf 3\",\"waitSeconds\":90}]";
    HttpResponse<String> answer =
        post(token, "api/v1/tasks", "{\"name\":\"tour\",\"load\":2,\"stops\":" + stops + "}");

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode task = JSON.readTree(answer.body());
    assertEquals("Dock A", task.get("start").get("station").stringValue());
    assertEquals("Shelf 3", task.get("goal").get("station").stringValue());
    assertEquals(3, task.get("stops").size());
    assertTrue(task.get("stops").get(1).get("waitForPerson").booleanValue());
    assertEquals(90, task.get("stops").get(2).get("waitSeconds").asInt());
    long id = task.get("id").asLong();
    server.fleet().changeTask(id, TaskState.CARRYING, List.of("r1"), "r1 carries it.");
    assertEquals(
        List.of("PASSED", "NEXT", "AHEAD"),
        JSON.readTree(get("api/v1/tasks/" + id).body()).get("stops").values().stream()
            .map(stop -> stop.get("state").stringValue())
            .toList());
    assertEquals(409, post(token, "api/v1/tasks/" + id + "/go-on", "{\"stop\":2}").statusCode());
    assertEquals(422, post(token, "api/v1/tasks/" + id + "/go-on", "{\"stop\":0}").statusCode());
  }

  @Test
  void aDriveHasAGoalOrStopsAndNoLoad() {
    HttpResponse<String> answer =
        post(
            token,
            "api/v1/tasks",
            "{\"name\":\"look\",\"kind\":\"DRIVE\",\"goal\":{\"station\":\"Dock A\"}}");

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode task = JSON.readTree(answer.body());
    assertEquals("DRIVE", task.get("kind").stringValue());
    assertEquals(0, task.get("load").asDouble());
    assertEquals(1, task.get("stops").size());
    assertEquals("Dock A", task.get("goal").get("station").stringValue());
    assertEquals(0, JSON.readTree(get("api/v1/loads").body()).size());

    answer =
        post(
            token,
            "api/v1/tasks",
            "{\"name\":\"round\",\"kind\":\"DRIVE\",\"stops\":[{\"station\":\"Dock A\",\"waitSeconds\":9},{\"x\":2,\"y\":1}]}");
    assertEquals(201, answer.statusCode(), answer.body());
    assertEquals(9, JSON.readTree(answer.body()).get("stops").get(0).get("waitSeconds").asInt());
  }

  @Test
  void aTaskMayChargeOnItsWay() {
    HttpResponse<String> answer =
        post(
            token,
            "api/v1/tasks",
            "{\"name\":\"tour\",\"load\":2,\"stops\":[{\"station\":\"Dock A\"},{\"charge\":{\"until\":0.8},\"waitSeconds\":900},{\"station\":\"Shelf 3\"}]}");

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode stops = JSON.readTree(answer.body()).get("stops");
    assertTrue(stops.get(0).get("charge").isNull());
    assertEquals(0.8, stops.get(1).get("charge").get("until").asDouble());
    assertTrue(stops.get(1).get("charge").get("charger").isNull());
    assertEquals(900, stops.get(1).get("waitSeconds").asInt());
  }

  @Test
  void aTaskSaysWhenItIsExpectedOrWhyNobodyCanSay() {
    long id = JSON.readTree(post(token, "api/v1/tasks", GOOD_TASK).body()).get("id").asLong();
    Instant pickUp = Instant.parse("2026-11-21T08:00:30Z");
    server
        .fleet()
        .changeView(
            id, task -> task.withExpected(new ExpectedTimes(pickUp, pickUp.plusSeconds(60), null)));

    JsonNode expected = JSON.readTree(get("api/v1/tasks/" + id).body()).get("expected");
    assertEquals("2026-11-21T08:00:30Z", expected.get("pickUp").stringValue());
    assertEquals("2026-11-21T08:01:30Z", expected.get("delivery").stringValue());
    assertTrue(expected.get("unknown").isNull());

    server
        .fleet()
        .changeView(
            id,
            task ->
                task.withExpected(
                    new ExpectedTimes(null, null, Phrase.EXPECTED_AFTER_HOLD.with())));
    JsonNode held = JSON.readTree(get("api/v1/tasks").body()).at("/0/expected");
    assertTrue(held.get("delivery").isNull());
    assertEquals("This depends on when it is resumed.", held.get("unknown").stringValue());
  }

  @Test
  void aTaskHasAllThatIsPromised() {
    long id = JSON.readTree(post(token, "api/v1/tasks", GOOD_TASK).body()).get("id").asLong();

    JsonNode waiting = JSON.readTree(get("api/v1/tasks/" + id).body());
    assertEquals("Looking for a robot.", waiting.get("waitingFor").stringValue());
    assertTrue(waiting.get("needs").isNull());
    assertTrue(waiting.get("expected").isNull());
    assertFalse(waiting.get("held").booleanValue());
    assertEquals(1, waiting.get("history").size());

    server.fleet().changeTask(id, TaskState.CARRYING, List.of("r1"), "r1 carries it.");
    JsonNode carried = JSON.readTree(get("api/v1/tasks/" + id).body());
    assertEquals("CARRYING", carried.get("state").stringValue());
    assertEquals("r1", carried.get("robots").get(0).stringValue());
    assertTrue(carried.get("waitingFor").isNull());
    assertEquals("r1 carries it.", carried.get("history").get(1).get("text").stringValue());
  }

  @Test
  void tasksAreListedNewestFirst() {
    for (int i = 0; i < 3; i++) {
      post(token, "api/v1/tasks", GOOD_TASK);
    }

    HttpResponse<String> answer = get("api/v1/tasks?offset=1&limit=2");

    assertEquals("3", answer.headers().firstValue("X-Total-Count").orElseThrow());
    JsonNode tasks = JSON.readTree(answer.body());
    assertEquals(2, tasks.get(0).get("id").asInt());
    assertEquals(1, tasks.get(1).get("id").asInt());
    assertEquals(200, get("api/v1/tasks?limit=99999999999").statusCode());
    assertEquals("[]", get("api/v1/tasks?offset=" + "9".repeat(101)).body());
    String one = "0".repeat(101) + "1";
    assertEquals(1, JSON.readTree(get("api/v1/tasks?limit=" + one).body()).size());
    assertEquals(400, get("api/v1/tasks?limit=0").statusCode());
    assertEquals(400, get("api/v1/tasks?offset=x").statusCode());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          {"name":"x","load":"2","start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | “load” must be a number without quotation marks.
          {"name":7,"load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | “name” must be a text in quotation marks.
          {"name":"x","load":2,"start":"Dock A","goal":{"station":"Shelf 3"}} | 422 | “start” must be an object with the name of a station ("station": "Store A") or with x and y in metres ("x": 1.5, "y": 2).
          {"name":"x","load":2,"start":{"x":1},"goal":{"station":"Shelf 3"}} | 422 | Choose a station, or enter x and y in metres.
          {"name":"x","load":2,"start":{"x":1,"y":1,"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | “start” must be an object with the name of a station ("station": "Store A") or with x and y in metres ("x": 1.5, "y": 2).
          {"name":"x","load":2,"goal":{"station":"Shelf 3"}} | 422 | “start” must be an object with the name of a station ("station": "Store A") or with x and y in metres ("x": 1.5, "y": 2).
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"colour":"red"} | 422 | Unknown field “colour”. Allowed: template, kind, stops, name, load, start, goal, floor, priority, deadline, size, onlyRobots, arm.
          {"name":"x","load":2,"start":{"station":"Dock A","z":1},"goal":{"station":"Shelf 3"}} | 422 | Unknown field “start.z”. Allowed: station.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"onlyRobots":"r1"} | 422 | “onlyRobots” must be a list of texts in brackets.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"onlyRobots":["r 1"]} | 422 | Name robots as the list of robots has them, such as r1 and r2, or what they can do: with:arm, with:omni.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"onlyRobots":["with:wings"]} | 422 | Name robots as the list of robots has them, such as r1 and r2, or what they can do: with:arm, with:omni.
          {"name":"x","load":2,"start":{"station":"Dock A"},"stops":[{"station":"Dock A"},{"station":"Shelf 3"}]} | 422 | Either start and goal, or stops. The first stop is the start, the last one the goal.
          {"name":"x","load":2,"stops":[{"station":"Dock A"}]} | 422 | At least two stops, the start and a goal.
          {"name":"x","load":2,"stops":[{"station":"Dock A"},{"station":"Shelf 3","waitSeconds":0}]} | 422 | Robots wait a whole number of seconds, from 1 to 86400.
          {"name":"x","kind":"FLY","load":1,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The kind of a task is TRANSPORT, or DRIVE for a drive without a load.
          {"name":"x","load":2,"stops":[{"station":"Dock A"},{"charge":{}}]} | 422 | A load is neither picked up nor delivered at a charger. Charge between the first and the last stop, or order a drive without a load.
          {"name":"x","kind":"DRIVE","stops":[{"charge":{"until":1.1}}]} | 422 | A robot charges to between 5 % and 100 %: in the API until 0.05 to 1.
          {"name":"x","kind":"DRIVE","stops":[{"charge":{"level":1}}]} | 422 | Unknown field “stops.0.charge.level”. Allowed: charger, until.
          {"name":"x","kind":"DRIVE","stops":[{"charge":{},"station":"Dock A"}]} | 422 | Either a charger, or a station or coordinates. Leave one of them out.
          {"name":"x","kind":"DRIVE","load":1,"goal":{"station":"Dock A"}} | 422 | A drive carries no load. Leave this empty, or order that a load is carried.
          {"name":"x","kind":"DRIVE","start":{"station":"Dock A"},"goal":{"station":"Dock A"}} | 422 | A drive begins where its robot is. Leave the start empty.
          {"name":"x","kind":"DRIVE","stops":[]} | 422 | At least one stop to which the robot drives.
          {"name":"x","kind":"DRIVE","goal":{"station":"Dock A"},"stops":[{"station":"Dock A"}]} | 422 | Either a goal or stops. The last stop is the goal.
          {"name":"x","load":0,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The weight must be above 0 and at most 100,000 kg.
          {"name":"x","load":1e999,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The weight must be above 0 and at most 100,000 kg.
          {"name":"x","load":2,"start":{"x":1e300,"y":1},"goal":{"station":"Shelf 3"}} | 422 | Coordinates must lie within 1,000,000 m of the map’s origin.
          {"name":"  ","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | Enter a task name.
          {"name":"\\u200b\\u00a0","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | Enter a task name.
          {"name":"a\\u0000b","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The task name contains characters that cannot be shown, such as line breaks. Remove them.
          {"name":"🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖🤖","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | A task name has at most 100 characters, this one has 101. Shorten it.
          {"name":"a\\u202eb","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The task name contains characters that cannot be shown, such as line breaks. Remove them.
          {"name":"\\ud800","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The task name contains characters that cannot be shown, such as line breaks. Remove them.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"priority":1.5} | 422 | The priority is a whole number from -100 to 100.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"deadline":"+99999-01-01T00:00:00Z"} | 422 | The deadline’s year must be from 2000 to 9998.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"deadline":"soon"} | 422 | Enter the deadline with its time zone, such as 2026-11-21T15:00:00Z.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"size":{"length":1}} | 422 | Enter both length and width in metres.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"x":0.1,"y":0.1}} | 422 | The goal is not a free place of the floor. Choose another one.
          {"name":"x","load":NaN} | 400 | The body is not valid JSON, at line 1, column 23. Correct it there.
          {"name":"x","name":"y"} | 400 | The body is not valid JSON, at line 1, column 19. Correct it there.
          {"name":"x"} {} | 400 | The body is not valid JSON, at line 1, column 14. Correct it there.
          [1] | 400 | The body must be one JSON object in braces.
          7 | 400 | The body must be one JSON object in braces.
          """)
  void aBadTaskGetsASentence(String body, int status, String sentence) {
    HttpResponse<String> answer = post(token, "api/v1/tasks", body);

    assertEquals(
        "application/problem+json", answer.headers().firstValue("Content-Type").orElseThrow());
    assertEquals(sentence, detail(answer));
    assertEquals(status, answer.statusCode());
    assertEquals(0, server.fleet().count());
  }

  @Test
  void everyFieldAtFaultIsNamed() {
    JsonNode problem = JSON.readTree(post(token, "api/v1/tasks", "{\"load\":-1}").body());

    Set<String> fields =
        problem.get("errors").values().stream()
            .map(error -> error.get("field").stringValue())
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(Set.of("name", "load", "start", "goal"), fields);
  }

  @Test
  void aSilentStoreIsSaidWithoutATrace() {
    server.fleet().stopAnswering();

    HttpResponse<String> answer = post(token, "api/v1/tasks", GOOD_TASK);

    assertEquals(503, answer.statusCode());
    assertEquals("5", answer.headers().firstValue("Retry-After").orElse(""));
    assertTrue(detail(answer).startsWith("The database does not answer, so nothing was changed."));
    assertFalse(answer.body().contains("Exception"));
  }
}
