package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.motion.Segment;

/** A robot that drives 3 m to the east from (2, 3), and the obstacles there. */
@Tag("full")
class ObstacleAvoidanceTest {
  private static final Segment METRE = new Segment(0.25, 0, 4);
  private static final Duration MINUTE = Duration.ofMinutes(1);
  private static final double RADIUS = 0.255 / 2;

  @TempDir Path folder;
  private final RoundObstacles things = new RoundObstacles();
  private Rig rig;
  private TestServer server;

  @BeforeEach
  void connect() {
    rig =
        new Rig(
            folder, new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1, things));
    server = rig.connect();
  }

  @AfterEach
  void close() {
    rig.close();
  }

  @Test
  void robotStopsBeforeABoxReportsItAndContinuesWhenItIsGone() {
    things.put(new Vec2(4, 3), 0.2);
    drive();
    State stopped = server.advanceUntil(s -> isStopped(s), MINUTE);

    assertEquals(Mode.DRIVING, stopped.mode());
    String text = stopped.errors().getFirst().text();
    assertTrue(
        text.matches(
            "There is an obstacle 0\\.(1[6-9]|20) m ahead; the robot waits until it is gone."),
        text);
    assertTrue(
        stopped.obstacles().stream().anyMatch(p -> p.distanceTo(new Vec2(3.8, 3)) < 0.02),
        stopped.obstacles().toString());
    assertEquals(0.18, things.nearest(), 0.03);

    server.advance(Duration.ofSeconds(10));
    List<Vec2> seen = server.state().obstacles();
    assertTrue(seen.stream().anyMatch(p -> p.y() < 2.88), "looked round to the right: " + seen);
    assertTrue(seen.stream().anyMatch(p -> p.y() > 3.12), "looked round to the left: " + seen);
    assertEquals(0, stopped.pose().distanceTo(server.pose()), 0.005);
    things.clear();
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    assertEquals(0, end.pose().position().distanceTo(new Vec2(5, 3)), 0.005);
    assertEquals(List.of(), end.obstacles());
  }

  @Test
  void aBlindMiddleSensorLeavesTheOuterOnes() {
    things.blindMiddle();
    things.put(new Vec2(4, 3), 0.2);
    drive();
    server.advanceUntil(s -> isStopped(s), MINUTE);

    assertTrue(things.nearest() > 0.05, "came as near as " + things.nearest());
  }

  @Test
  void robotStepsAsideForWhatReachesInAndComesBack() {
    things.put(new Vec2(3.5, 3 + RADIUS + 0.15 + 0.004), 0.15); // 4 mm beside the robot's width
    drive();
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);

    assertTrue(things.nearest() > 0.006, "came as near as " + things.nearest());
    List<State> states = server.received(State.class);
    assertTrue(states.stream().noneMatch(ObstacleAvoidanceTest::isObstructed));
    double aside = states.stream().mapToDouble(s -> 3 - s.pose().y()).max().orElseThrow();
    assertTrue(aside > 0.003 && aside < 0.012, "aside by " + aside);
    assertEquals(0, end.pose().position().distanceTo(new Vec2(5, 3)), 0.002);
  }

  @Test
  void wallBesideTheTrajectoryHasNoEffect() {
    for (double x = 2; x < 5.3; x += 0.02) {
      things.put(new Vec2(x, 3 + RADIUS + 0.0225 + 0.02), 0.02);
    }
    drive();
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);

    List<State> states = server.received(State.class);
    assertTrue(states.stream().anyMatch(s -> s.ranges().getLast() < 0.5), "sees the wall");
    assertTrue(states.stream().allMatch(s -> s.obstacles().isEmpty()));
    double aside = states.stream().mapToDouble(s -> Math.abs(3 - s.pose().y())).max().orElseThrow();
    assertTrue(aside < 0.002, "aside by " + aside);
  }

  @Test
  void crossingObstacleIsLetPass() {
    things.putMoving(new Vec2(3.6, 1.6), 0.2, new Vec2(0, 0.25));
    drive();
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);

    assertTrue(things.nearest() > 0.02, "came as near as " + things.nearest());
    assertTrue(server.received(State.class).stream().anyMatch(ObstacleAvoidanceTest::isObstructed));
    assertEquals(0, end.pose().position().distanceTo(new Vec2(5, 3)), 0.005);
  }

  private void drive() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE, METRE, METRE)));
  }

  private static boolean isStopped(State state) {
    return isObstructed(state) && Math.abs(state.twist().v()) < 0.001;
  }

  private static boolean isObstructed(State state) {
    return state.errors().stream().map(Fault::code).anyMatch("OBSTACLE"::equals);
  }
}
