package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.testbed.Hall;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;

/** Robots and floors of the API: shown, added, paired, commanded. */
class ApiRobotsTest extends ApiTestServer {
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
            none -> List.of(Hall.robot("r1", RobotState.IDLE, new Pose(1, 1, 0), "h", 7275)));
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
  void aStopIsClearedByTheReasonsThatWereShown() {
    RobotView robot = Hall.robot("r1", RobotState.ERROR, new Pose(1, 1, 0), "h", 7275);
    Fault edge = new Fault("STOP_EDGE", "A floor sensor sees no floor.", true);
    Fault blind = new Fault("RANGE_SENSORS", "It sees nothing.");
    server
        .fleet()
        .setRobots(robot.withTelemetry(robot.telemetry().withErrors(List.of(edge, blind))));
    JsonNode errors = JSON.readTree(get("api/v1/robots/r1").body()).get("errors");
    assertTrue(errors.get(0).get("clearable").booleanValue());
    assertFalse(errors.get(1).get("clearable").booleanValue());

    assertEquals(422, post(token, "api/v1/robots/r1/clear", "{}").statusCode());
    assertEquals(422, post(token, "api/v1/robots/r1/clear", "{\"reasons\":[]}").statusCode());
    HttpResponse<String> other =
        post(token, "api/v1/robots/r1/clear", "{\"reasons\":[\"STOP_SWITCH\"]}");
    assertEquals(409, other.statusCode(), other.body());
    assertTrue(detail(other).startsWith("What stops r1 has changed meanwhile: "), detail(other));

    HttpResponse<String> cleared =
        post(token, "api/v1/robots/r1/clear", "{\"reasons\":[\"STOP_EDGE\"]}");
    assertEquals(200, cleared.statusCode(), cleared.body());
    assertEquals("IDLE", JSON.readTree(cleared.body()).get("state").asString());
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
    assertTrue(detail(get("api/v1/map?floor=roof")).contains("Available: hall."));
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
  void onlyManagersSayWhichRobotsAreInService(String command) {
    String path = "api/v1/robots/r1/" + command;

    HttpResponse<String> ofClerk = post(tokenOf(WebTestServer.CLERK), path, "{}");

    assertEquals(403, ofClerk.statusCode());
    assertTrue(detail(ofClerk).startsWith("Only operators and managers may do this."));
    assertEquals(401, post(null, path, "{}").statusCode());
    assertEquals("IDLE", state("r1"));
    assertEquals(404, post(token, "api/v1/robots/none/" + command, "{}").statusCode());
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
    assertTrue(detail(ofClerk).startsWith("Only operators and managers may do this."));
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
}
