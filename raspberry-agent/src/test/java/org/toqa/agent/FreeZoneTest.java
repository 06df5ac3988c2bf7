package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.RoomUse;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.motion.FreeZone;
import org.toqa.motion.Segment;

/**
 * A robot with four agents has a path of 6 m to the east from (2, 3), of which a free zone of 4 m
 * by 3 m, from (3, 1.5) on, is lent to it.
 */
@Tag("full")
class FreeZoneTest {
  private static final int PIECES = 15;
  private static final Segment PIECE = new Segment(0.25, 0, 1.6);
  private static final Duration MINUTES = Duration.ofMinutes(3);
  private static final double RADIUS = 0.255 / 2;
  private static final FreeZone ZONE = zone(List.of());

  /** Between (3.2, 3) and (6.8, 3). */
  private static final int FROM = 3;

  private static final int TO = 12;

  @TempDir Path folder;
  private final RoundObstacles things = new RoundObstacles();
  private Rig rig;
  private TestServer server;

  @BeforeEach
  void connect() {
    rig =
        Rig.withFourAgents(
            folder, new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1, things));
    server = rig.connect();
    server.assertAccepted(
        TestServer.drive(1, 5L, 1, Rig.START, Collections.nCopies(PIECES, PIECE)));
  }

  @AfterEach
  void close() {
    rig.close();
  }

  private static FreeZone zone(List<FreeZone.Obstacle> known) {
    return new FreeZone(3, 1.5, 4, 3, 0.25, known);
  }

  @Test
  void itSaysThatItCan() {
    assertTrue(server.hello().freeZones());
    assertEquals(8, server.state().ranges().size());
  }

  @Test
  void anEmptyZoneIsCrossedWithoutAStop() {
    lend(ZONE);
    crosses();
  }

  @ParameterizedTest
  @CsvSource({"0, 0.15", "0.1, 0.15", "-0.1, 0.15", "0, 0.25", "0.05, 0.12"})
  void whatTheMapShowsIsGoneRound(double aside, double radius) {
    Vec2 middle = new Vec2(5, 3 + aside);
    things.put(middle, radius);
    lend(zone(List.of(new FreeZone.Obstacle(middle.x(), middle.y(), radius))));
    crosses();
    assertTrue(things.nearest() > 0.02, "came as near as " + things.nearest());
  }

  /** At most at half the robot's speed. */
  @ParameterizedTest
  @CsvSource({
    "5, 1.6, 0, 0.1",
    "5, 4.4, 0, -0.1",
    "5, 2, 0, 0.12",
    "6.5, 3.3, -0.1, 0",
    "6.5, 2.7, -0.12, 0",
    "4.5, 1.8, 0, 0.08",
    "6.5, 3, -0.1, 0",
    "6.5, 3.1, -0.12, 0"
  })
  void whatMovesIsPassedWithoutContact(double x, double y, double vx, double vy) {
    things.putMoving(new Vec2(x, y), 0.15, new Vec2(vx, vy));
    lend(ZONE);
    crosses();
    assertTrue(things.nearest() > 0, "came as near as " + things.nearest());
    assertTrue(things.nearest() < 1.5, "did not meet it: " + things.nearest());
  }

  /** Something may come after it wherever it gives way to, and push it where it stands. */
  @ParameterizedTest
  @CsvSource({
    "6.4, 2, -0.08, 0.08, 0.15",
    "5.83, 2.38, -0.112, 0.05, 0.1",
    "5.34, 3.7, -0.045, -0.06, 0.2",
    "6.35, 2.02, -0.053, 0.074, 0.2",
    "4.56, 2.03, -0.057, 0.063, 0.3",
    "6.5, 3.05, -0.25, 0, 0.15"
  })
  void itNeverDrivesIntoWhatComesAfterIt(double x, double y, double vx, double vy, double radius) {
    things.putMoving(new Vec2(x, y), radius, new Vec2(vx, vy));
    lend(ZONE);
    for (int i = 0; i < 80; i++) {
      server.advance(Duration.ofMillis(500));
    }
    assertFalse(things.wasDrivenInto(), "drove into it");
    assertTrue(things.nearest() < 0.5, "did not meet it: " + things.nearest());
  }

  @Test
  void itHoldsWhenItIsToldTo() {
    lend(ZONE);
    server.advanceUntil(s -> s.pose().x() > 4.5, MINUTES);
    server.assertAccepted(new Hold(3));
    server.advance(Duration.ofSeconds(3));
    Pose there = things.truth();
    server.advance(Duration.ofSeconds(30));
    assertEquals(0, there.distanceTo(things.truth()), 0.001);
    assertEquals(RoomUse.HELD, server.state().room());
    server = rig.connect();
    assertEquals(ZONE, Objects.requireNonNull(server.hello().room()).zone());
    server.assertAccepted(new Resume(4));
    crosses();
  }

  @Test
  void segmentsCountAsCompletedAsItComesNearer() {
    lend(ZONE);
    server.advanceUntil(s -> s.pose().x() > 5.1, MINUTES);
    assertEquals(7, server.state().segment(), 1); // 7 x 0.4 m = 2.8 m behind (2, 3)
    server.advanceUntil(s -> s.pose().x() > 6.3, MINUTES);
    assertEquals(10, server.state().segment(), 1);
    crosses();
  }

  @Test
  void itSaysWhenItDoesNotFindItsWayAndStandsUntilItIsCancelled() {
    for (double y = 1.3; y < 4.8; y += 0.2) {
      things.put(new Vec2(5, y), 0.12);
    }
    lend(ZONE);
    server.advanceUntil(FreeZoneTest::isStuck, MINUTES);
    server.advance(Duration.ofSeconds(2));
    Pose there = things.truth();
    server.advance(Duration.ofSeconds(20));
    assertEquals(0, there.distanceTo(things.truth()), 0.001);
    assertEquals(Mode.DRIVING, server.state().mode());
    assertEquals(RoomUse.HELD, server.state().room());
    assertTrue(things.nearest() > 0, "came as near as " + things.nearest());
    assertTrue(ZONE.inside(there.position(), RADIUS) > -0.001);

    server.assertAccepted(new Cancel(3, 5L));
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTES);
    assertEquals(RoomUse.NONE, end.room());
    assertFalse(isStuck(end));
  }

  /** Whatever pushes it about, its middle stays as far inside as its rim needs. */
  @ParameterizedTest
  @CsvSource({"5, 2, 0, 0.1", "4, 1.7, 0.02, 0.1", "6, 4, -0.05, -0.1", "5, 3, -0.1, 0.02"})
  void itNeverLeavesTheZone(double x, double y, double vx, double vy) {
    things.putMoving(new Vec2(x, y), 0.3, new Vec2(vx, vy));
    lend(ZONE);
    server.advanceUntil(s -> s.segment() >= FROM, MINUTES);
    double least = Double.POSITIVE_INFINITY;
    int looks = 0;
    while (server.state().room() == RoomUse.HELD && !isStuck(server.state())) {
      server.advance(Duration.ofMillis(100));
      least = Math.min(least, ZONE.inside(things.truth().position(), RADIUS));
      looks++;
    }
    assertTrue(looks > 100, "was in the zone for %d tenths of a second".formatted(looks));
    assertTrue(least > -0.002, "out by " + -least);
  }

  @Test
  void whatItCannotDoIsRefused() {
    assertEquals(
        "At (2.40, 3.00) the robot would reach out of the free zone.",
        server.rejectReason(new Room(2, 1, 1, TO, 0, 0, ZONE)));
    assertEquals(
        "Room can be lent beside segments that are released, 0 to 15, not 3 to 16.",
        server.rejectReason(new Room(3, 1, FROM, PIECES + 1, 0, 0, ZONE)));
  }

  private void lend(FreeZone zone) {
    server.assertAccepted(new Room(2, 1, FROM, TO, 0, 0, zone));
  }

  private void crosses() {
    State behind = server.advanceUntil(s -> s.room() == RoomUse.NONE || isStuck(s), MINUTES);
    assertFalse(isStuck(behind), () -> "it is stuck at " + behind.pose());
    assertEquals(0, behind.pose().position().distanceTo(new Vec2(6.8, 3)), 0.06);
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTES);
    assertEquals(0, end.pose().position().distanceTo(new Vec2(8, 3)), 0.02);
    SimulatedChassis body = (SimulatedChassis) rig.body();
    assertEquals(0, body.truePose().theta(), 0.02);
  }

  private static boolean isStuck(State state) {
    return state.errors().stream().map(Fault::code).anyMatch("ZONE_STUCK"::equals);
  }
}
