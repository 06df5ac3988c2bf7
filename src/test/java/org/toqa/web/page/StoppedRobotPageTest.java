package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.testbed.Hall;
import org.toqa.web.WebServerTest;

/** A robot that its own hardware stopped, on its page. */
class StoppedRobotPageTest extends WebServerTest {
  private static final String SENTENCE = "A floor sensor sees no floor.";
  private static final String FORM = "action=\"/robots/r1/clear\"";

  @BeforeEach
  void stopRobot() {
    RobotView robot =
        Hall.robot("r1", RobotState.ERROR, new Pose(1.05, 0.75, 0), "127.0.0.1", 7275);
    Fault stop = new Fault("STOP_EDGE", "Words of the robot.", true);
    Fault other = new Fault("MY_OWN", "Another fault.");
    server
        .fleet()
        .setRobots(robot.withTelemetry(robot.telemetry().withErrors(List.of(stop, other))));
  }

  @Test
  void aManagerIsShownTheReasonAndConfirms() {
    String page = manager.get("robots/r1").body();
    assertTrue(page.contains(FORM), page);
    assertTrue(page.contains("name=\"reasons\" value=\"STOP_EDGE\""), page);
    assertFalse(page.contains("value=\"MY_OWN\""), "it goes by itself");
    assertTrue(page.contains(SENTENCE) && page.contains("Another fault."), page);
    assertFalse(page.contains("???"), page);
    assertFalse(page.contains("(<bdi dir=\"ltr\">STOP_EDGE"), "a code in place of words");

    HttpResponse<String> other = manager.post("robots/r1/clear", Map.of("reasons", "STOP_SWITCH"));
    assertEquals(422, other.statusCode());
    assertTrue(other.body().contains("What stops r1 has changed meanwhile"), other.body());
    assertEquals(422, manager.post("robots/r1/clear", Map.of()).statusCode());

    assertEquals(303, manager.post("robots/r1/clear", Map.of("reasons", "STOP_EDGE")).statusCode());
    assertFalse(manager.get("robots/r1").body().contains(FORM));
  }

  @Test
  void aClerkIsShownTheReasonOnly() {
    String page = clerk.get("robots/r1").body();

    assertTrue(page.contains(SENTENCE), page);
    assertFalse(page.contains(FORM), page);
    assertEquals(403, clerk.post("robots/r1/clear", Map.of("reasons", "STOP_EDGE")).statusCode());
  }
}
