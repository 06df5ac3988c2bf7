package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Scanner;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.history.TrackPoint;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskState;
import org.toqa.web.TestClient;
import org.toqa.web.TestFleet;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Sentence;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class ApiTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final String GOOD_TASK =
      """
      {"name": " Box of bolts ", "load": 2.5, "start": {"station": "Dock A"},
       "goal": {"x": 10.35, "y": 1.05}}
      """;

  private WebTestServer server;
  private TestClient visitor;
  private String token;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.start();
    visitor = new TestClient(server.root());
    token = tokenOf(WebTestServer.MANAGER);
    server
        .fleet()
        .changeRobots(
            none ->
                List.of(
                    TestFleet.robot(
                        "r1", RobotState.IDLE, new Pose(1.05, 0.75, 0), "127.0.0.1", 7275)));
  }

  @AfterEach
  void stop() throws Exception {
    visitor.close();
    server.close();
  }

  @Test
  void theServerIsUp() {
    assertEquals("{\"status\":\"UP\"}", visitor.get("api/v1/health").body());
  }

  @Test
  void whatAilsTheFleetIsInItsHealth() {
    server.fleet().setAlert("The database does not answer.");

    HttpResponse<String> answer = visitor.get("api/v1/health");

    assertEquals(503, answer.statusCode());
    JsonNode health = JSON.readTree(answer.body());
    assertEquals("DEGRADED", health.get("status").stringValue());
    assertEquals("The database does not answer.", health.get("alerts").get(0).stringValue());
  }

  @Test
  void theHistoryIsFilteredAndPaged() {
    Instant at = Instant.parse("2026-11-21T08:00:00Z");
    server
        .store()
        .addEvents(
            List.of(
                new EventRecord(at, "robot.held", null, "r1", "Max", Sentence.verbatim("one")),
                new EventRecord(at, "task.started", 7L, "r1", "toqa", Sentence.verbatim("two")),
                new EventRecord(at, "task.started", 8L, "r2", "toqa", Sentence.verbatim("three"))));

    JsonNode first = JSON.readTree(get("api/v1/history?robot=r1&limit=1").body());
    JsonNode second =
        JSON.readTree(get("api/v1/history?robot=r1&before=" + first.get("next").asLong()).body());

    assertEquals("two", first.get("events").get(0).get("text").stringValue());
    assertEquals("one", second.get("events").get(0).get("text").stringValue());
    assertTrue(second.get("next").isNull());
    assertEquals(
        1,
        JSON.readTree(get("api/v1/history?until=2026-11-21&task=8").body()).get("events").size());
    HttpResponse<String> wrong = get("api/v1/history?task=x&from=yesterday&kind=A");
    assertEquals(422, wrong.statusCode());
    assertEquals(3, JSON.readTree(wrong.body()).get("errors").size());
  }

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
    HttpResponse<String> wrong = get("api/v1/tasks?state=new&sort=x&until=soon");
    assertEquals(422, wrong.statusCode());
    assertEquals(3, JSON.readTree(wrong.body()).get("errors").size());
  }

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

  @Test
  void aRobotHasATrack() {
    server
        .fleet()
        .changeRobots(
            none -> List.of(TestFleet.robot("r1", RobotState.IDLE, new Pose(1, 1, 0), "h", 7275)));
    server.store().saveRobot(new RobotRecord("r1", "hall", "h", 7275, 5, null, false, null));
    Instant now = server.fleet().latest().at();
    server
        .tracks()
        .add(
            List.of(
                new TrackPoint("r1", now.minusSeconds(7200), new Vec2(1, 1)),
                new TrackPoint("r1", now.minusSeconds(60), new Vec2(2.5, 1))));

    JsonNode points = JSON.readTree(get("api/v1/tracks/r1?hours=1").body()).get("points");

    assertEquals(1, points.size());
    assertEquals(2.5, points.get(0).get("x").asDouble());
    assertEquals(404, get("api/v1/tracks/r9").statusCode());
  }

  @Test
  void aFloorHasTheTracksOfItsRobots() {
    server.store().saveRobot(new RobotRecord("r1", "hall", "h", 7275, 5, null, false, null));
    Instant at = Instant.parse("2026-11-21T08:00:00Z");
    server
        .tracks()
        .add(
            List.of(
                new TrackPoint("r1", at.minusSeconds(60), new Vec2(1, 1)),
                new TrackPoint("r1", at.plusMillis(1500), new Vec2(2.125, 1)),
                new TrackPoint("r1", at.plusSeconds(7200), new Vec2(3, 1))));

    JsonNode tracks =
        JSON.readTree(
            get("api/v1/tracks?floor=hall&from=2026-11-21T08:00:00Z&until=2026-11-21T09:00:00Z")
                .body());

    assertEquals("hall", tracks.get("floor").stringValue());
    assertEquals("2026-11-21T09:00:00Z", tracks.get("until").stringValue());
    assertEquals("r1", tracks.get("robots").get(0).get("robot").stringValue());
    assertEquals(
        "[[-60000.0,1.0,1.0],[1500.0,2.125,1.0],[7200000.0,3.0,1.0]]",
        tracks.get("robots").get(0).get("points").toString());
    JsonNode usual = JSON.readTree(get("api/v1/tracks").body());
    assertEquals(
        Duration.ofMinutes(10),
        Duration.between(
            Instant.parse(usual.get("from").stringValue()),
            Instant.parse(usual.get("until").stringValue())));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          floor=cellar | 404 | There is no floor of that name. There are: hall.
          from=yesterday | 422 | Write a moment with its offset from UTC, such as 2026-11-21T08:00:00Z.
          until=2026-11-21 | 422 | Write a moment with its offset from UTC, such as 2026-11-21T08:00:00Z.
          until=%2B999999999-01-01T00:00:00Z | 422 | Write a moment with its offset from UTC, such as 2026-11-21T08:00:00Z.
          from=1999-12-31T23:59:59Z | 422 | Write a moment with its offset from UTC, such as 2026-11-21T08:00:00Z.
          from=2026-11-21T08:00:00Z&until=2026-11-21T08:00:00Z | 422 | The period must end after it begins, and last an hour at most.
          from=2026-11-21T08:00:00Z&until=2026-11-21T09:00:01Z | 422 | The period must end after it begins, and last an hour at most.
          """)
  void aBadPeriodOfTracksGetsASentence(String query, int status, String sentence) {
    HttpResponse<String> answer = get("api/v1/tracks?" + query);

    assertEquals(sentence, detail(answer));
    assertEquals(status, answer.statusCode());
  }

  @Test
  void theTracksOfAHundredRobotsInAnHourAreBelowAMegabyte() {
    List<String> names = IntStream.rangeClosed(1, 100).mapToObj(i -> "r" + i).toList();
    Instant at = Instant.parse("2026-11-21T08:00:00Z");
    server
        .fleet()
        .changeRobots(
            none ->
                names.stream()
                    .map(
                        name ->
                            TestFleet.robot(name, RobotState.IDLE, new Pose(1, 1, 0), "h", 7275))
                    .toList());
    for (String name : names) {
      server.store().saveRobot(new RobotRecord(name, "hall", "h", 7275, 5, null, false, null));
    }
    server
        .tracks()
        .add(
            names.stream()
                .flatMap(
                    name ->
                        IntStream.range(0, 600) // one each six seconds
                            .mapToObj(
                                i ->
                                    new TrackPoint(
                                        name,
                                        at.plusSeconds(6L * i),
                                        new Vec2(100.001 + i / 7.0, 99.999))))
                .toList());

    HttpResponse<String> answer =
        get("api/v1/tracks?from=2026-11-21T08:00:00Z&until=2026-11-21T09:00:00Z");

    assertEquals(200, answer.statusCode());
    assertTrue(answer.body().length() < 1_000_000, () -> answer.body().length() + " bytes");
    assertEquals(
        "2026-11-21T08:30:00Z", // 300 points of each are 30,000
        JSON.readTree(answer.body()).get("until").stringValue());
  }

  @Test
  void aCodeThatIsNoneIsRefusedAtItsField() {
    HttpResponse<String> answer =
        post(
            token,
            "api/v1/robots",
            "{\"name\":\"r9\",\"host\":\"h\",\"port\":7275,\"maxLoad\":5,\"code\":\"ABC-1\"}");

    assertEquals(422, answer.statusCode());
    assertEquals("code", JSON.readTree(answer.body()).get("errors").get(0).get("field").asString());
    assertEquals(404, get("api/v1/robots/r9").statusCode());
  }

  @Test
  void aManagerPairsARobotAnew() {
    server
        .fleet()
        .changeRobots(
            none -> List.of(TestFleet.robot("r1", RobotState.IDLE, new Pose(1, 1, 0), "h", 7275)));
    HttpResponse<String> answer =
        post(
            token,
            "api/v1/robots/r1/pair",
            "{\"host\":\"wifi\",\"port\":7276,\"code\":\"DDLD-XYIK-2VCK-ASRC-ABCDE-FGH27\"}");

    assertEquals(200, answer.statusCode(), answer.body());
    assertEquals("wifi", JSON.readTree(answer.body()).get("host").asString());
    assertEquals(
        422, post(token, "api/v1/robots/r1/pair", "{\"host\":\"h\",\"port\":7276}").statusCode());
  }

  @Test
  void aWrongPasswordGivesNoToken() {
    HttpResponse<String> answer =
        post(null, "api/v1/session", "{\"name\":\"Max\",\"password\":\"wrong\"}");

    assertEquals(401, answer.statusCode());
    assertEquals("Name or password is wrong. Check both and try again.", detail(answer));
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
  void aTaskHasAllThatIsPromised() {
    long id = JSON.readTree(post(token, "api/v1/tasks", GOOD_TASK).body()).get("id").asLong();

    JsonNode waiting = JSON.readTree(get("api/v1/tasks/" + id).body());
    assertEquals("Looking for a robot.", waiting.get("waitingFor").stringValue());
    assertTrue(waiting.get("needs").isNull());
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
          {"name":"x","load":2,"start":"Dock A","goal":{"station":"Shelf 3"}} | 422 | “start” must be an object in braces.
          {"name":"x","load":2,"start":{"x":1},"goal":{"station":"Shelf 3"}} | 422 | Choose a station, or enter x and y in metres.
          {"name":"x","load":2,"start":{"x":1,"y":1,"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | “start” needs either a station’s name or x and y in metres.
          {"name":"x","load":2,"goal":{"station":"Shelf 3"}} | 422 | “start” needs either a station’s name or x and y in metres.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"colour":"red"} | 422 | The field “colour” is unknown. Known here: name, load, start, goal, floor, priority, deadline, size.
          {"name":"x","load":2,"start":{"station":"Dock A","z":1},"goal":{"station":"Shelf 3"}} | 422 | The field “start.z” is unknown. Known here: station.
          {"name":"x","load":0,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The weight must be above 0 and at most 100,000 kg.
          {"name":"x","load":1e999,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The weight must be above 0 and at most 100,000 kg.
          {"name":"x","load":2,"start":{"x":1e300,"y":1},"goal":{"station":"Shelf 3"}} | 422 | Coordinates must lie within 1,000,000 m of the map’s origin.
          {"name":"  ","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | Give the task a name.
          {"name":"a\\u0000b","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The task name has characters that cannot be shown, such as line breaks. Leave them out.
          {"name":"\\ud800","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}} | 422 | The task name has characters that cannot be shown, such as line breaks. Leave them out.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"priority":1.5} | 422 | The priority is a whole number from -100 to 100.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"deadline":"+99999-01-01T00:00:00Z"} | 422 | The deadline’s year must be from 2000 to 9998.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"deadline":"soon"} | 422 | The deadline is a time with its zone, as in 2026-11-21T15:00:00Z.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"},"size":{"length":1}} | 422 | The size needs a length and a width in metres.
          {"name":"x","load":2,"start":{"station":"Dock A"},"goal":{"x":0.1,"y":0.1}} | 422 | The goal is not a free place of the floor. Choose another one.
          {"name":"x","load":NaN} | 400 | The body is not valid JSON, at line 1, column 23. Mend it there.
          {"name":"x","name":"y"} | 400 | The body is not valid JSON, at line 1, column 19. Mend it there.
          {"name":"x"} {} | 400 | The body is not valid JSON, at line 1, column 14. Mend it there.
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
  void aNumberOfAMillionDigitsIsRefused() {
    String digits = "9".repeat(50_000);

    assertEquals(
        400, post(token, "api/v1/tasks", "{\"name\":\"x\",\"load\":" + digits + "}").statusCode());
  }

  @Test
  void aBodyTooLargeIsRefused() {
    String body = "{\"name\":\"" + "x".repeat(64 * 1024) + "\"}";

    HttpResponse<String> answer = post(token, "api/v1/tasks", body);

    assertEquals(413, answer.statusCode());
    assertEquals("The body is larger than 64 KiB. Send less.", detail(answer));
  }

  @ParameterizedTest
  @ValueSource(strings = {"text/plain", "application/xml", "application/x-www-form-urlencoded"})
  void anotherMediaTypeIsRefused(String mediaType) {
    HttpResponse<String> answer =
        visitor.send(
            visitor
                .request("api/v1/tasks")
                .header("Authorization", "Bearer " + token)
                .header("Content-Type", mediaType)
                .POST(BodyPublishers.ofString(GOOD_TASK))
                .build());

    assertEquals(415, answer.statusCode());
    assertEquals("Send the body as application/json.", detail(answer));
  }

  @Test
  void theWrongMethodNamesTheRightOnes() {
    HttpResponse<String> answer = visitor.send("PUT", "api/v1/tasks");

    assertEquals(405, answer.statusCode());
    assertEquals("GET, HEAD, POST", answer.headers().firstValue("Allow").orElseThrow());
    assertTrue(detail(answer).contains("It takes: GET, HEAD, POST."));
  }

  @ParameterizedTest
  @ValueSource(strings = {"api/v1/tasks/99", "api/v1/tasks/x", "api/v1/robots/none", "api/v1/no"})
  void whatIsNotThereIsAProblem(String path) {
    HttpResponse<String> answer = get(path);

    assertEquals(404, answer.statusCode());
    assertEquals(404, JSON.readTree(answer.body()).get("status").asInt());
  }

  @Test
  void theMapHasAllThatIsPromised() {
    JsonNode map = JSON.readTree(get("api/v1/map").body());

    assertEquals("hall", map.get("floor").stringValue());
    assertEquals(40, map.get("width").asInt());
    assertEquals(20, map.get("height").asInt());
    assertEquals(0.3, map.get("resolution").doubleValue());
    assertEquals(0, map.get("origin").get("x").doubleValue());
    assertEquals("Dock A", map.get("stations").get(0).get("name").stringValue());
    assertEquals(3, map.get("parking").size());
    assertEquals(10.95, map.get("charging").get(0).get("x").doubleValue());
    // row 0 and the left cell of row 1 are one run of 40 + 1 cells
    assertEquals(0, map.get("occupied").get(0).asInt());
    assertEquals(41, map.get("occupied").get(1).asInt());
    assertEquals(404, get("api/v1/map?floor=roof").statusCode());
    assertTrue(detail(get("api/v1/map?floor=roof")).contains("There are: hall."));
  }

  @Test
  void aRobotIsAddedAndLocated() {
    HttpResponse<String> added =
        post(
            token,
            "api/v1/robots",
            "{\"name\":\"r2\",\"host\":\"127.0.0.1\",\"port\":7276,\"maxLoad\":5}");
    assertEquals(201, added.statusCode());
    assertEquals("CONNECTING", JSON.readTree(added.body()).get("state").stringValue());

    HttpResponse<String> located =
        post(token, "api/v1/robots/r2/locate", "{\"x\":2.25,\"y\":0.75,\"theta\":1.5}");
    assertEquals(200, located.statusCode());
    JsonNode robot = JSON.readTree(get("api/v1/robots/r2").body());
    assertEquals(1.5, robot.get("pose").get("theta").doubleValue());
    assertEquals(2, JSON.readTree(get("api/v1/robots").body()).size());
    assertEquals(
        404,
        post(token, "api/v1/robots/none/locate", "{\"x\":2.25,\"y\":0.75,\"theta\":0}")
            .statusCode());
  }

  @Test
  void aManagerTakesARobotOutOfServiceAndPutsItBack() {
    HttpResponse<String> out = post(token, "api/v1/robots/r1/out-of-service", "");
    assertEquals(200, out.statusCode());
    assertEquals("OUT_OF_SERVICE", JSON.readTree(out.body()).get("state").stringValue());
    assertEquals("OUT_OF_SERVICE", state("r1"));

    HttpResponse<String> in = post(token, "api/v1/robots/r1/in-service", "{}");
    assertEquals(200, in.statusCode());
    assertEquals("IDLE", JSON.readTree(in.body()).get("state").stringValue());
    assertEquals("IDLE", state("r1"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"out-of-service", "in-service"})
  void onlyManagersSayWhichRobotsAreInService(String wish) {
    String path = "api/v1/robots/r1/" + wish;

    HttpResponse<String> ofClerk = post(tokenOf(WebTestServer.CLERK), path, "{}");

    assertEquals(403, ofClerk.statusCode());
    assertTrue(detail(ofClerk).startsWith("Only a manager may do this."));
    assertEquals(401, post(null, path, "{}").statusCode());
    assertEquals("IDLE", state("r1"));
    assertEquals(404, post(token, "api/v1/robots/none/" + wish, "{}").statusCode());
    assertEquals(405, get(path).statusCode());
  }

  @ParameterizedTest
  @ValueSource(strings = {"hold", "resume", "home"})
  void onlyManagersGiveRobotsOrders(String order) {
    String path = "api/v1/robots/r1/" + order;

    assertEquals(403, post(tokenOf(WebTestServer.CLERK), path, "").statusCode());
    assertEquals(401, post(null, path, "").statusCode());
    assertEquals(404, post(token, "api/v1/robots/none/" + order, "").statusCode());
    assertEquals(405, get(path).statusCode());
    assertEquals(200, post(token, path, "").statusCode());
  }

  @Test
  void everybodyPausesAllRobotsAndOnlyAManagerLetsThemGoOn() {
    String clerk = tokenOf(WebTestServer.CLERK);
    assertEquals(401, post(null, "api/v1/fleet/pause", "").statusCode());
    assertTrue(JSON.readTree(get("api/v1/fleet").body()).get("pause").isNull());

    HttpResponse<String> paused = post(clerk, "api/v1/fleet/pause", "");

    assertEquals(200, paused.statusCode());
    assertEquals(
        WebTestServer.CLERK, JSON.readTree(paused.body()).get("pause").get("user").stringValue());
    HttpResponse<String> ofClerk = post(clerk, "api/v1/fleet/resume", "");
    assertEquals(403, ofClerk.statusCode());
    assertTrue(detail(ofClerk).startsWith("Only a manager may do this."));
    HttpResponse<String> ofManager = post(token, "api/v1/fleet/resume", "");
    assertEquals(200, ofManager.statusCode());
    assertTrue(JSON.readTree(ofManager.body()).get("pause").isNull());
  }

  @Test
  void aManagerPutsAFloorOnHoldAndLetsItsRobotsGoOn() {
    String clerk = tokenOf(WebTestServer.CLERK);
    assertEquals(401, post(null, "api/v1/floors/hall/hold", "").statusCode());
    assertEquals(403, post(clerk, "api/v1/floors/hall/hold", "").statusCode());
    HttpResponse<String> unknown = post(token, "api/v1/floors/attic/hold", "");
    assertEquals(404, unknown.statusCode());
    assertEquals("There is no floor attic.", detail(unknown));

    HttpResponse<String> held = post(token, "api/v1/floors/hall/hold", "");
    assertEquals(200, held.statusCode());
    assertEquals(
        WebTestServer.MANAGER, JSON.readTree(held.body()).get("hold").get("user").stringValue());
    HttpResponse<String> resumed = post(token, "api/v1/floors/hall/resume", "");
    assertEquals(200, resumed.statusCode());
    assertTrue(JSON.readTree(resumed.body()).get("hold").isNull());
  }

  @ParameterizedTest
  @ValueSource(strings = {"cancel", "hold", "resume", "answer"})
  void aTaskIsChangedByItsOwnerAndByManagersOnly(String wish) {
    long others = add(token);
    String body = wish.equals("answer") ? "{\"answer\":\"wait\"}" : "";
    String clerk = tokenOf(WebTestServer.CLERK);

    HttpResponse<String> ofClerk = post(clerk, "api/v1/tasks/" + others + "/" + wish, body);

    assertEquals(403, ofClerk.statusCode());
    assertTrue(detail(ofClerk).startsWith("This is another user’s task."));
    assertEquals(401, post(null, "api/v1/tasks/" + others + "/" + wish, body).statusCode());
    assertEquals(404, post(token, "api/v1/tasks/999/" + wish, body).statusCode());
    assertEquals(404, post(token, "api/v1/tasks/x/" + wish, body).statusCode());
    assertEquals(405, get("api/v1/tasks/" + others + "/" + wish).statusCode());
    int expected = wish.equals("answer") ? 409 : 200; // it asks nothing
    long own = add(clerk);
    assertEquals(expected, post(clerk, "api/v1/tasks/" + own + "/" + wish, body).statusCode());
    assertEquals(expected, post(token, "api/v1/tasks/" + own + "/" + wish, body).statusCode());
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
    assertTrue(detail(tooLate).endsWith("has ended; it cannot be changed any more."));
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

  private long add(String bearer) {
    return JSON.readTree(post(bearer, "api/v1/tasks", GOOD_TASK).body()).get("id").longValue();
  }

  @Test
  void theStreamTellsWhatIsInTheWay() {
    server.fleet().changeFloor(TestFleet.crowdedFloor());
    HttpResponse<InputStream> stream =
        visitor.send(
            visitor.request("api/v1/events").header("Authorization", "Bearer " + token).build(),
            BodyHandlers.ofInputStream());

    try (Scanner lines = new Scanner(stream.body(), StandardCharsets.UTF_8)) {
      JsonNode floor = JSON.readTree(after("data: ", lines)).get("floors").get(0);
      assertEquals("hall", floor.get("floor").stringValue());
      assertEquals("[375,2,415,2]", floor.get("obstacles").toString());
      assertEquals(
          "{\"robot\":\"r6\",\"cells\":[490,2,530,2]}", floor.get("kept").get(0).toString());
      JsonNode standstill = floor.get("standstills").get(0);
      assertEquals("[\"r2\",\"r3\"]", standstill.get("robots").toString());
      assertEquals(2.25, standstill.get("where").get(0).get("x").doubleValue());
      assertTrue(standstill.get("text").stringValue().contains("wait for each other"));
      JsonNode charger = floor.get("faultyChargers").get(0);
      assertEquals("C1", charger.get("name").stringValue());
      assertEquals(10.95, charger.get("where").get("x").doubleValue());
    }
  }

  @Test
  void aSessionWritesWithItsToken() {
    try (TestClient clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      assertEquals(201, clerk.postJson("api/v1/tasks", GOOD_TASK).statusCode());
    }
  }

  @Test
  void aTokenThatIsNoneOpensNothing() {
    HttpResponse<String> answer =
        visitor.send(
            visitor.request("api/v1/map").header("Authorization", "Bearer guessed").build());

    assertEquals(401, answer.statusCode());
    assertEquals("Bearer", answer.headers().firstValue("WWW-Authenticate").orElseThrow());
  }

  @Test
  void aSilentStoreIsSaidWithoutATrace() {
    server.fleet().stopAnswering();

    HttpResponse<String> answer = post(token, "api/v1/tasks", GOOD_TASK);

    assertEquals(503, answer.statusCode());
    assertTrue(detail(answer).startsWith("The database does not answer, so nothing was changed."));
    assertFalse(answer.body().contains("Exception"));
  }

  @Test
  void theStreamBringsEachNewSnapshot() {
    HttpResponse<InputStream> stream =
        visitor.send(
            visitor.request("api/v1/events").header("Authorization", "Bearer " + token).build(),
            BodyHandlers.ofInputStream());
    assertEquals(
        "text/event-stream;charset=UTF-8",
        stream.headers().firstValue("Content-Type").orElseThrow());

    try (Scanner lines = new Scanner(stream.body(), StandardCharsets.UTF_8)) {
      long first = version(lines);
      server
          .fleet()
          .changeRobots(
              robots ->
                  List.of(
                      TestFleet.robot(
                          "r1", RobotState.DRIVING, new Pose(2, 2, 0), "127.0.0.1", 7275)));
      long second = version(lines);
      assertEquals(first + 1, second);
      JsonNode snapshot = JSON.readTree(after("data: ", lines));
      assertEquals(second, snapshot.get("version").asLong());
      assertEquals("DRIVING", snapshot.get("robots").get(0).get("state").stringValue());
      assertTrue(snapshot.get("tasks").isArray());
    }
  }

  private static long version(Scanner lines) {
    String id = after("id: ", lines);
    return Long.parseLong(id.substring(id.lastIndexOf('-') + 1));
  }

  private static String after(String prefix, Scanner lines) {
    String line = lines.nextLine();
    while (!line.startsWith(prefix)) {
      line = lines.nextLine();
    }
    return line.substring(prefix.length());
  }

  @Test
  void aManagerAddsChangesAndDeletesUsers() {
    HttpResponse<String> added =
        post(token, "api/v1/users", "{\"name\":\"Omar\",\"password\":\"another long one\"}");
    assertEquals(201, added.statusCode());
    JsonNode omar = JSON.readTree(added.body());
    assertEquals("CLERK", omar.get("role").stringValue());
    assertFalse(added.body().contains("argon2"));
    String path = "api/v1/users/" + omar.get("id").asLong();
    assertTrue(added.headers().firstValue("Location").orElseThrow().endsWith(path));

    HttpResponse<String> changed = send("PUT", path, "{\"role\":\"MANAGER\",\"disabled\":true}");
    assertEquals(200, changed.statusCode());
    assertTrue(JSON.readTree(changed.body()).get("disabled").asBoolean());
    HttpResponse<String> login =
        post(null, "api/v1/session", "{\"name\":\"omar\",\"password\":\"another long one\"}");
    assertEquals(403, login.statusCode());
    assertTrue(detail(login).startsWith("A manager has disabled this user."));

    assertEquals(204, send("DELETE", path, "").statusCode());
    assertEquals(404, send("DELETE", path, "").statusCode());
    assertEquals(2, JSON.readTree(get("api/v1/users").body()).size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{\"name\":\"Omar\",\"password\":\"short\"}|422|at least 10 characters",
        "{\"name\":\"Omar\",\"password\":\"password123\"}|422|among the first that are guessed",
        "{\"name\":\"Omarovich\",\"password\":\"omarovich1\"}|422|among the first that are guessed",
        "{\"name\":\"Omar\",\"password\":\"a long good one\",\"role\":\"KING\"}|422|CLERK or MANAGER",
        "{\"name\":\"MAX\",\"password\":\"a long good one\"}|409|This name is taken",
        "{\"name\":\"Omar\",\"password\":\"a long good one\",\"boss\":1}|422|boss"
      })
  void aUserWhoCannotBeAddedIsRefusedWithASentence(String body, int status, String sentence) {
    HttpResponse<String> answer = post(token, "api/v1/users", body);

    assertEquals(status, answer.statusCode(), answer.body());
    assertTrue(answer.body().contains(sentence), answer.body());
  }

  @Test
  void theLastManagerStaysOneAndAClerkChangesOnlyHisOwnPassword() {
    long max = server.accounts().accountByName(WebTestServer.MANAGER).orElseThrow().id();
    assertEquals(409, send("PUT", "api/v1/users/" + max, "{\"role\":\"CLERK\"}").statusCode());
    assertEquals(409, send("DELETE", "api/v1/users/" + max, "").statusCode());
    assertEquals(422, send("PUT", "api/v1/users/" + max, "{\"disabled\":\"no\"}").statusCode());

    String clerk = tokenOf(WebTestServer.CLERK);
    long clara = server.accounts().accountByName(WebTestServer.CLERK).orElseThrow().id();
    String path = "api/v1/users/" + clara + "/password";
    String withoutOld = "{\"password\":\"quite another password\"}";
    assertEquals(404, post(clerk, "api/v1/users/" + max + "/password", withoutOld).statusCode());
    assertEquals(422, post(clerk, path, withoutOld).statusCode());
    String withOld = withoutOld.replace("}", ",\"old\":\"" + WebTestServer.PASSWORD + "\"}");
    assertEquals(204, post(clerk, path, withOld).statusCode());
    assertEquals(401, post(clerk, path, withOld).statusCode(), "the token has ended");
  }

  private HttpResponse<String> send(String method, String path, String body) {
    return visitor.send(
        visitor
            .request(path)
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "application/json")
            .method(method, BodyPublishers.ofString(body))
            .build());
  }

  private String tokenOf(String name) {
    HttpResponse<String> answer =
        post(
            null,
            "api/v1/session",
            "{\"name\":\"%s\",\"password\":\"%s\"}".formatted(name, WebTestServer.PASSWORD));
    assertEquals(200, answer.statusCode());
    return JSON.readTree(answer.body()).get("token").stringValue();
  }

  private String state(String robot) {
    return JSON.readTree(get("api/v1/robots/" + robot).body()).get("state").stringValue();
  }

  private HttpResponse<String> get(String path) {
    return visitor.send(visitor.request(path).header("Authorization", "Bearer " + token).build());
  }

  private HttpResponse<String> post(@Nullable String bearer, String path, String body) {
    var request = visitor.request(path).header("Content-Type", "application/json; charset=utf-8");
    if (bearer != null) {
      request.header("Authorization", "Bearer " + bearer);
    }
    return visitor.send(request.POST(BodyPublishers.ofString(body)).build());
  }

  private static String detail(HttpResponse<String> answer) {
    return JSON.readTree(answer.body()).get("detail").stringValue();
  }
}
