package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.motion.DriveKind;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** A robot on two wheels, seen from its server: it drives what any robot is given. */
@Tag("full")
class DifferentialRobotTest {
  private static final Duration MINUTES = Duration.ofMinutes(5);
  private static final Segment METRE = new Segment(0.25, 0, 4);

  @TempDir Path folder;
  private final RoundObstacles things = new RoundObstacles();
  private Rig rig;
  private TestServer server;

  @BeforeEach
  void connect() {
    rig =
        new Rig(
            folder,
            DriveKind.DIFFERENTIAL,
            new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1, things),
            chassis -> chassis);
    server = rig.connect();
  }

  @AfterEach
  void close() {
    rig.close();
  }

  @Test
  void itTellsItsKind() {
    assertEquals(DriveKind.DIFFERENTIAL, server.hello().driveKind());
    assertFalse(server.hello().shifts());
  }

  /** Straights, corners as the server rounds them, and turns on the spot, fast and slow. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void itStaysOnItsPath(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<Segment> segments = Stream.generate(() -> segment(random)).limit(12).toList();
    Trajectory planned = new Trajectory(Rig.START, segments);
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, segments));
    double worst = 0;
    for (int i = 0; i < 6000 && server.state().mode() != Mode.IDLE; i++) {
      server.advance(Duration.ofMillis(60));
      worst = Math.max(worst, distance(planned, body().truePose()));
    }

    assertEquals(Mode.IDLE, server.state().mode());
    assertTrue(worst < 0.02, "off the path by " + worst + " m");
    Pose end = body().truePose();
    assertEquals(0, planned.end().distanceTo(end), 0.01);
    assertEquals(0, Angles.difference(planned.end().theta(), end.theta()), 0.01);
  }

  /** It cannot come back where it stands; it does while it drives on. */
  @Test
  void itComesBackToItsPathWhenItWasPushedAside() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE, METRE)));
    server.advanceUntil(s -> s.pose().x() > 2.4, MINUTES);
    server.assertAccepted(new Hold(2));
    server.advance(Duration.ofSeconds(5));
    body().shove(new Vec2(0, 0.035));
    server.advance(Duration.ofSeconds(2));
    assertEquals(0.035, server.pose().y() - 3, 0.003);
    server.assertAccepted(new Resume(3));
    server.advanceUntil(s -> s.pose().x() > 3.5, MINUTES);
    assertEquals(3, server.pose().y(), 0.005);
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTES);
    assertEquals(0, end.pose().position().distanceTo(new Vec2(4, 3)), 0.005);
  }

  @Test
  void itStopsBeforeWhatAnotherWouldStepAsideFrom() {
    things.put(new Vec2(4, 3 + 0.1275 + 0.05 + 0.005), 0.05);
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE, METRE, METRE)));
    server.advance(Duration.ofSeconds(40));
    assertEquals(Mode.DRIVING, server.state().mode());
    assertEquals("OBSTACLE", server.state().errors().getFirst().code());
    things.clear();
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTES);
    assertEquals(5, server.pose().x(), 0.005);
  }

  private SimulatedChassis body() {
    return (SimulatedChassis) rig.body();
  }

  private static Segment segment(SplittableRandom random) {
    double speed = random.nextDouble(0.1, 0.5);
    double side = random.nextBoolean() ? 1 : -1;
    double angle = random.nextDouble(0.2, Math.PI / 2);
    return switch (random.nextInt(3)) {
      case 0 -> new Segment(speed, 0, random.nextDouble(0.2, 1.5) / speed);
      case 1 -> { // radius 0.15 m and more
        double rate = Math.min(1.5, speed / random.nextDouble(0.15, 1));
        yield new Segment(speed, side * rate, angle / rate);
      }
      default -> new Segment(0, side * 1.5, angle / 1.5);
    };
  }

  private static double distance(Trajectory path, Pose robot) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < path.segments().size(); i++) {
      Segment segment = path.segments().get(i);
      for (int j = 0; j <= 40; j++) {
        Pose there = path.poseAfter(i).advanced(segment.twist(), segment.t() * j / 40);
        nearest = Math.min(nearest, there.distanceTo(robot));
      }
    }
    return nearest;
  }
}
