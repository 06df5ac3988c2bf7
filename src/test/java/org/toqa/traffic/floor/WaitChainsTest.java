package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.wording.Sentence;

class WaitChainsTest {
  private final OccupancyGrid grid = DrivenFloor.draw("....");
  private final Map<String, TrafficRobot> robots = new TreeMap<>();
  private final WaitChains chains = new WaitChains();

  @Test
  void whoWaitsForOneThatWaitsIsToldOfTheLast() {
    wait("a", "b");
    wait("b", "c");
    add("c").setMovable(false);
    chains.update(robots);
    assertEquals(Optional.of("c"), blocking("a"));
    assertEquals(Optional.of("c"), blocking("b"));
    assertEquals(Optional.empty(), blocking("c"));
    assertEquals("Waiting for b to pass at (1.00, 2.00), behind c", sentence("a"));
    assertEquals("Waiting for c to pass at (1.00, 2.00)", sentence("b"));
  }

  @Test
  void whoCannotMoveEndsTheChainWhateverItWaitedFor() {
    wait("a", "b");
    wait("b", "c").setMovable(false);
    add("c");
    chains.update(robots);
    assertEquals(Optional.of("b"), blocking("a"));
  }

  @Test
  void thoseInARingAndBehindItWaitForNobodyInTheEnd() {
    wait("a", "b");
    wait("b", "c");
    wait("c", "b");
    chains.update(robots);
    assertEquals(Optional.empty(), blocking("a"));
    assertEquals(Optional.empty(), blocking("b"));
  }

  /** Most waits are the same from tick to tick. */
  @Test
  void aSentenceIsMadeAnewWhereTheReasonOrTheLastBecomesAnother() {
    wait("a", "b");
    wait("b", "c");
    add("c").setMovable(false);
    add("d").setMovable(false);
    chains.update(robots);
    Sentence said = chains.sentence(add("a"));
    wait("a", "b");
    chains.update(robots);
    assertSame(said, chains.sentence(add("a")));

    wait("b", "d");
    chains.update(robots);
    assertEquals("Waiting for b to pass at (1.00, 2.00), behind d", sentence("a"));
    wait("a", "d");
    chains.update(robots);
    assertEquals("Waiting for d to pass at (1.00, 2.00)", sentence("a"));
  }

  private Optional<String> blocking(String robot) {
    return chains.blockingRobot(add(robot));
  }

  private String sentence(String robot) {
    return String.valueOf(chains.sentence(add(robot)));
  }

  private TrafficRobot wait(String robot, String other) {
    TrafficRobot waiting = add(robot);
    waiting.waiting.setBlockedReason(new WaitReason.RobotPassing(other, new Vec2(1, 2)));
    return waiting;
  }

  /** It can move, and has no path. */
  private TrafficRobot add(String name) {
    return robots.computeIfAbsent(
        name,
        key -> {
          TrafficRobot robot =
              new TrafficRobot(
                  name, robots.size() + 1, grid, new Pose(0.2, 0.2, 0), 0.1, Instant.EPOCH);
          robot.setMovable(true);
          return robot;
        });
  }
}
