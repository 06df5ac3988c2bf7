package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.RobotView.Readings;
import org.toqa.fleet.RobotView.Telemetry;
import org.toqa.link.message.AgentMessage.NetworkRoute;
import org.toqa.testbed.Hall;

class RelayChainTest {

  /** A robot at 10.0.9.NUMBER. */
  private static RobotView robot(int number, @Nullable String nextHop) {
    NetworkRoute route = nextHop == null ? null : new NetworkRoute(nextHop, 256, 1);
    return Hall.robot("r" + number, RobotState.IDLE, null, "10.0.9." + number, 7275)
        .withTelemetry(
            new Telemetry(
                null,
                null,
                new Readings(null, null, List.of(), null, null, null, null, route, null),
                List.of(),
                null));
  }

  private static List<String> relays(RobotView... fleet) {
    return RelayChain.of(fleet[0], List.of(fleet));
  }

  @Test
  void chainIsFollowedToTheServer() {
    assertEquals(
        List.of("r2", "r1"),
        relays(robot(3, "10.0.9.2"), robot(2, "10.0.9.1"), robot(1, "10.0.9.100")));
  }

  @Test
  void whoseNextHopIsTheServerHasNone() {
    assertEquals(List.of(), relays(robot(1, "10.0.9.100"), robot(2, "10.0.9.1")));
    assertEquals(List.of(), relays(robot(1, null), robot(2, "10.0.9.1")));
  }

  @Test
  void chainOfWhichARobotToldNothingEndsThere() {
    assertEquals(List.of("r2"), relays(robot(3, "10.0.9.2"), robot(2, null)));
  }

  @Test
  void whatWasToldBeforeARouteChangedMakesNoCircle() {
    assertEquals(List.of("r2"), relays(robot(3, "10.0.9.2"), robot(2, "10.0.9.3")));
    assertEquals(
        List.of("r2", "r1"),
        relays(robot(3, "10.0.9.2"), robot(2, "10.0.9.1"), robot(1, "10.0.9.2")));
  }
}
