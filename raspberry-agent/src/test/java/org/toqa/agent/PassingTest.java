package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
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
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;

/** A robot drives 4 m to the east from (2, 3), and is lent room where it asks for it. */
@Tag("full")
class PassingTest {
  private static final int PIECES = 10;
  private static final Segment PIECE = new Segment(0.25, 0, 1.6);
  private static final Duration MINUTE = Duration.ofMinutes(1);
  private static final Duration STANDS_WITHIN = Duration.ofSeconds(2);

  /** The truth of a thing of 0.1 m is never nearer than that, metres. */
  private static final double CLEARANCE = 0.01;

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
    server.assertAccepted(
        TestServer.drive(1, 5L, 1, Rig.START, Collections.nCopies(PIECES, PIECE)));
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

    server.advanceUntil(s -> s.room() == RoomUse.WANTED, MINUTE);
    lend(2, left, right);
    drivesOnToItsEnd();

    assertTrue(things.nearest() >= CLEARANCE, "came as near as " + things.nearest());
    assertTrue(
        server.received(State.class).stream().anyMatch(s -> s.room() == RoomUse.HELD), "held it");
  }

  @ParameterizedTest
  @CsvSource({"0.4, 1.3", "-0.4, 1.2", "0.2, 1.3", "-0.2, 1.1", "0.1, 1.2", "0.1, 1.5", "0.3, 1.2"})
  void passesSomethingThatCrossesWithoutAStop(double pace, double crossed) {
    things.putWalking(new Vec2(4, 3 - pace * crossed), 0.05, new Vec2(0, pace));

    server.advanceUntil(s -> s.room() == RoomUse.WANTED, MINUTE);
    lend(2, 0.4, 0.4);
    drivesOnToItsEnd();

    assertTrue(things.nearest() >= CLEARANCE, "came as near as " + things.nearest());
  }

  /**
   * What comes along with the robot to the side on which it passes may stop it; it is not touched.
   */
  @ParameterizedTest
  @CsvSource({"0.2, 1.2", "0.2, 1.5", "0.2, 2", "-0.2, 1.6", "-0.6, 1.3", "0.4, 1.5", "1, 1.2"})
  void neverTouchesWhatCrosses(double pace, double crossed) {
    things.putWalking(new Vec2(4, 3 - pace * crossed), 0.05, new Vec2(0, pace));

    server.advanceUntil(s -> s.room() == RoomUse.WANTED, MINUTE);
    lend(2, 0.4, 0.4);
    server.advance(MINUTE.dividedBy(2));

    assertTrue(things.nearest() > 0, "came as near as " + things.nearest());
  }

  /** It looked round for ever, so its drive never ended, and it was given no other. */
  @Test
  void whoIsStoppedInItsRoomAndShallNotGoOnStands() {
    things.put(new Vec2(4, 3), 0.05);
    server.advanceUntil(s -> s.room() == RoomUse.WANTED, MINUTE);
    lend(2, 0.4, 0.4);
    for (int i = -8; i <= 8; i++) {
      things.put(new Vec2(4, 3 + 0.1 * i), 0.05);
    }
    server.advanceUntil(PassingTest::isObstructed, MINUTE);

    server.assertAccepted(new Hold(3));
    server.advance(STANDS_WITHIN);
    assertEquals(0, server.state().twist().w(), 0.01);
    server.assertAccepted(new Resume(4));
    server.advanceUntil(PassingTest::isObstructed, MINUTE);

    server.assertAccepted(new Cancel(5, 5L));
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, STANDS_WITHIN);
    assertEquals(0, end.drive());
  }

  @Test
  void roomIsRefusedWhereItHelpsNobody() {
    String refused = server.rejectReason(new Room(2, 1, 0, PIECES + 1, 0.3, 0));
    assertEquals(
        "Room can be lent beside segments that are released, 0 to 10, not 0 to 11.", refused);
    refused = server.rejectReason(new Room(3, 1, 0, 2, -0.1, 0));
    assertEquals("Room beside a path is 0 to 1.0 m wide, not -0.1 and 0.0 m.", refused);
    refused = server.rejectReason(new Room(4, 9, 0, 2, 0.3, 0));
    assertEquals("There is no drive 9 any more; the robot has drive 1.", refused);
  }

  @Test
  void theHelloTellsTheRoomThatItHasAndAnotherOneThatItHasNone() {
    things.put(new Vec2(4, 3), 0.05);
    server.advanceUntil(s -> s.room() == RoomUse.WANTED, MINUTE);
    int from = server.state().segment();
    lend(2, 0.4, 0);
    server.advanceUntil(s -> s.room() == RoomUse.HELD && s.pose().y() > 3.05, MINUTE);

    server = rig.connect();
    assertEquals(new PassingRoom(from, PIECES, 0.4, 0), server.hello().room());
    drivesOnToItsEnd();
    assertNull(rig.connect().hello().room());
  }

  private void lend(long seq, double left, double right) {
    State now = server.state();
    server.assertAccepted(new Room(seq, 1, now.segment(), PIECES, left, right));
  }

  private void drivesOnToItsEnd() {
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    List<State> states = server.received(State.class);
    assertTrue(states.stream().noneMatch(PassingTest::isObstructed), "it stopped");
    assertEquals(0, end.pose().position().distanceTo(new Vec2(6, 3)), 0.005);
    assertEquals(RoomUse.NONE, end.room());
  }

  private static boolean isObstructed(State state) {
    return state.errors().stream().map(Fault::code).anyMatch("OBSTACLE"::equals);
  }
}
