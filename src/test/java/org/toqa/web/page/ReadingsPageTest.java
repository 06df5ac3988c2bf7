package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.telemetry.ReadingLimits;
import org.toqa.telemetry.Topics;
import org.toqa.testbed.Hall;
import org.toqa.web.WebServerTest;

/** What a robot publishes by MQTT, on its page. */
class ReadingsPageTest extends WebServerTest {
  private static final Pattern PASSWORD =
      Pattern.compile("<code class=\"secret\" dir=\"ltr\">([^<]+)<");

  @BeforeEach
  void addRobot() {
    server
        .fleet()
        .setRobots(Hall.robot("r1", RobotState.IDLE, new Pose(1.05, 0.75, 0), "127.0.0.1", 7275));
  }

  private void publish(String reading, String body) {
    server
        .telemetry()
        .board()
        .receive(
            new Topics("main").origin("toqa/v1/main/robot/r1/" + reading),
            body.getBytes(StandardCharsets.UTF_8),
            false,
            Instant.now());
  }

  @Test
  void everybodySeesWhatARobotMeasures() {
    publish("range", "{\"stamp\":1,\"metres\":[0.25,1.5]}");
    publish("heat", "{\"stamp\":1,\"value\":21.5,\"unit\":\"<b>\"}");
    publish("heat", "nonsense");
    publish("connection", "online");

    String page = clerk.get("robots/r1").body();

    assertTrue(page.contains("0.25, 1.5 m"), page);
    assertTrue(page.contains("21.5 &lt;b&gt;"), page);
    assertTrue(page.contains("1 that are no JSON object"), page);
    assertTrue(page.contains("Its MQTT client is connected since"), page);
    assertFalse(page.contains("mqtt-password"), "it is for managers");
    assertFalse(page.contains("???"), page);
  }

  @Test
  void managerSetsLimitsAndRemovesThem() {
    Map<String, String> wrong = Map.of("reading", "range", "low", "2", "high", "1");
    assertEquals(422, manager.post("robots/r1/limits", wrong).statusCode());
    assertEquals(
        422, manager.post("robots/r1/limits", Map.of("reading", "State", "low", "2")).statusCode());
    assertEquals(
        303,
        manager.post("robots/r1/limits", Map.of("reading", "range", "low", "0.3")).statusCode());
    assertEquals(
        List.of(new ReadingLimits("r1", "range", 0.3, null)), server.telemetry().limits("r1"));
    assertTrue(manager.get("robots/r1").body().contains("at least 0.3"));
    assertEquals(403, clerk.post("robots/r1/limits", Map.of("reading", "range")).statusCode());
    assertEquals(303, manager.post("robots/r1/limits", Map.of("reading", "range")).statusCode());
    assertEquals(List.of(), server.telemetry().limits("r1"));
  }

  @Test
  void passwordIsShownOnceAndKeptAsItsHash() {
    assertEquals(303, manager.post("robots/r1/mqtt-password", Map.of()).statusCode());
    String page = manager.get("robots/r1").body();
    assertTrue(page.contains("main/robot/r1"), page);
    Matcher shown = PASSWORD.matcher(page);
    assertTrue(shown.find(), page);
    assertTrue(server.telemetry().isPassword("r1", shown.group(1)));
    assertFalse(server.telemetry().isPassword("r2", shown.group(1)));
    assertFalse(PASSWORD.matcher(manager.get("robots/r1").body()).find(), "not again");
    manager.post("robots/r1/mqtt-password", Map.of());
    assertFalse(server.telemetry().isPassword("r1", shown.group(1)), "it was replaced");
  }
}
