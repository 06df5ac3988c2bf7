package org.toqa.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.link.message.AgentMessage.NetworkRoute;

/**
 * Which robots of the fleet forward for one in an ad hoc network, each found as the next hop that
 * the one before it told. What they told may be a second old, so while routes mend the chain may
 * end early; it never goes in a circle.
 */
public final class RelayChain {

  private RelayChain() {}

  /**
   * Their names, the nearest to the robot first; empty: none, or its next hop is no robot.
   *
   * @param fleet all robots that may forward
   */
  public static List<String> of(RobotView robot, List<RobotView> fleet) {
    List<String> relays = new ArrayList<>();
    Optional<RobotView> relay = nextHop(robot, fleet);
    while (relay.isPresent()
        && !relay.get().name().equals(robot.name())
        && !relays.contains(relay.get().name())) {
      relays.add(relay.get().name());
      relay = nextHop(relay.get(), fleet);
    }
    return relays;
  }

  private static Optional<RobotView> nextHop(RobotView robot, List<RobotView> fleet) {
    @Nullable NetworkRoute route = robot.telemetry().readings().networkRoute();
    return route == null
        ? Optional.empty()
        : fleet.stream().filter(one -> one.record().host().equals(route.nextHop())).findFirst();
  }
}
