package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.RoomUse;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.motion.DriveKind;
import org.toqa.motion.Segment;

/**
 * A robot that cannot go sideways, with range sensors ahead and to both sides, drives 4 m to the
 * east from (2, 3), and is lent room whenever it asks for it.
 */
@Tag("full")
class PassingOnTwoWheelsTest {
  private static final int PIECES = 10;
  private static final Segment PIECE = new Segment(0.25, 0, 1.6);
  private static final Duration MINUTE = Duration.ofMinutes(1);
  private static final Duration REPORTED = Duration.ofMillis(200);

  /** Seconds until it is halfway, where things cross its path. */
  private static final double HALFWAY = 8;

  /** The truth of a thing of 0.1 m is never nearer than that, metres. */
  private static final double CLEARANCE = 0.01;

  /** Where its sensors look, radians. */
  private static final List<Double> ANGLES =
      Stream.of(-90, -50, -25, -10, 0, 10, 25, 50, 90).map(Math::toRadians).toList();

  @TempDir Path folder;
  private final RoundObstacles things = new RoundObstacles();
  private Rig rig;
  private TestServer server;
  private long seq;

  @BeforeEach
  void connect() {
    rig =
        new Rig(
            folder,
            DriveKind.DIFFERENTIAL,
            new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1, things, ANGLES),
            chassis -> chassis);
    server = rig.connect();
    server.assertAccepted(
        TestServer.drive(++seq, 5L, 1, Rig.START, Collections.nCopies(PIECES, PIECE)));
  }

  @AfterEach
  void close() {
    rig.close();
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0.4, 0.4",
    "0, 0.4, 0",
    "0, 0, 0.4",
    "0.03, 0, 0.4",
    "-0.03, 0.4, 0",
    "0.1, 0.4, 0.4",
    "0.15, 0, 0.2",
    "0.17, 0.4, 0.4",
    "-0.12, 0.2, 0.1",
    "-0.12, 0.35, 0.35"
  })
  void passesSomethingSmallWithoutAStop(double aside, double left, double right) {
    things.put(new Vec2(4, 3 + aside), 0.05);

    drivesOnToItsEnd(left, right);

    List<State> states = server.received(State.class);
    assertTrue(states.stream().noneMatch(PassingOnTwoWheelsTest::isObstructed), "it stopped");
    assertTrue(states.stream().anyMatch(s -> s.room() == RoomUse.HELD), "it held room");
    assertTrue(things.nearest() >= CLEARANCE, "came as near as " + things.nearest());
  }

  /** A thing that moves as the robot does, so that it is there when the robot comes. */
  @ParameterizedTest
  @CsvSource({
    "0.4, 1.3",
    "-0.4, 1.2",
    "0.2, 1.2",
    "0.2, 1.3",
    "0.2, 1.5",
    "0.2, 2",
    "-0.2, 1.1",
    "-0.2, 1.6",
    "0.1, 1.2",
    "0.1, 1.5",
    "0.3, 1.2",
    "-0.6, 1.3",
    "0.4, 1.5",
    "1, 1.2"
  })
  void neverTouchesWhatGoesAlongBesideIt(double pace, double crossed) {
    things.putWalking(new Vec2(4, 3 - pace * crossed), 0.05, new Vec2(0, pace));

    drive(0.4, 0.4);

    assertTrue(things.nearest() > 0, "came as near as " + things.nearest());
  }

  /**
   * Somebody of 0.3 m, as slow as in CSM-MAMRS and faster, comes onto its path and leaves it.
   *
   * @param late seconds after the robot would be there
   */
  @ParameterizedTest
  @CsvSource({
    "0, 0.096, -1",
    "0, 0.096, 0",
    "0, 0.096, 1",
    "0, -0.096, -0.5",
    "0, -0.096, 0.5",
    "-0.05, 0.05, 0",
    "-0.1, 0.05, 0",
    "0, 0.2, -1",
    "0, 0.2, 0",
    "0, -0.4, -1"
  })
  void waitsForSomebodyOrGoesRoundHimAndComesToItsEnd(double vx, double vy, double late) {
    double seconds = HALFWAY + late;
    things.putMoving(new Vec2(4 - vx * seconds, 3 - vy * seconds), 0.15, new Vec2(vx, vy));

    drivesOnToItsEnd(0.4, 0.4);

    assertFalse(things.wasDrivenInto());
  }

  private void drivesOnToItsEnd(double left, double right) {
    drive(left, right);
    State end = server.state();
    assertEquals(Mode.IDLE, end.mode());
    assertEquals(RoomUse.NONE, end.room());
    assertEquals(0, end.pose().position().distanceTo(new Vec2(6, 3)), 0.005);
  }

  /** Drives for a minute at most. */
  private void drive(double left, double right) {
    long end = rig.nanos() + MINUTE.toNanos();
    while (server.state().mode() != Mode.IDLE && rig.nanos() < end) {
      State now = server.state();
      if (now.room() == RoomUse.WANTED) {
        server.assertAccepted(new Room(++seq, 1, now.segment(), PIECES, left, right));
      }
      server.advance(REPORTED);
    }
  }

  private static boolean isObstructed(State state) {
    return state.errors().stream().map(Fault::code).anyMatch("OBSTACLE"::equals);
  }
}
