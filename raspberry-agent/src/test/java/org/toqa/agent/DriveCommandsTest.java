package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.agent.chassis.Chassis;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.motion.Segment;

/** What a robot refuses, and in which words. */
class DriveCommandsTest extends ConnectedRobotTest {
  @Test
  void driveFromWhereTheRobotStandsIsAccepted() {
    assertEquals(new Ack(1), server.ask(driveOf(1, METRE)));
    assertEquals(Mode.DRIVING, server.state().mode());
  }

  @Test
  void secondDriveWaitsForTheEndOfTheFirst() {
    server.assertAccepted(driveOf(1, METRE));
    server.advance(Duration.ofSeconds(1));

    assertEquals(
        "The robot has not ended drive 1; wait for its end or send cancel.",
        server.rejectReason(driveOf(2, METRE)));
  }

  @Test
  void driveIsRefusedWhileACancelledOneComesToAStand() {
    server.assertAccepted(driveOf(1, METRE));
    server.advance(Duration.ofSeconds(2));
    server.assertAccepted(new Cancel(2, 5L));

    assertEquals(
        "The robot is still moving; wait until it has stopped.",
        server.rejectReason(driveOf(3, METRE)));
  }

  @ParameterizedTest
  @CsvSource({"2.15, 3, 0", "2, 2.85, 0", "2, 3, 0.2", "200, 3, 0"})
  void driveThatStartsElsewhereIsRefused(double x, double y, double theta) {
    String reason =
        server.rejectReason(TestServer.drive(1, 5L, 1, new Pose(x, y, theta), List.of(METRE)));

    assertTrue(reason.startsWith("The drive starts "), reason);
    assertTrue(reason.endsWith(" where the robot is, (2.00, 3.00) facing 0 degrees."), reason);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          0.6  | 0   | 1    | Segment 1 has 0.6 m/s; this robot drives at most 0.5 m/s.
          -0.6 | 0   | 1    | Segment 1 has -0.6 m/s; this robot drives at most 0.5 m/s.
          0    | 3.6 | 1    | Segment 1 turns by 3.6 rad/s; this robot turns by at most 3.5 rad/s.
          0.1  | 0   | 0    | Segment 1 lasts 0.0 s; a segment lasts more than 0 and at most 3600 s.
          0.1  | 0   | -2   | Segment 1 lasts -2.0 s; a segment lasts more than 0 and at most 3600 s.
          0.1  | 0   | 9999 | Segment 1 lasts 9999.0 s; a segment lasts more than 0 and at most 3600 s.
          """)
  void segmentThatTheBodyCannotDriveIsRefused(double v, double w, double t, String reason) {
    assertEquals(reason, server.rejectReason(driveOf(1, METRE, new Segment(v, w, t))));
    assertEquals(Mode.IDLE, server.state().mode());
  }

  /** The body drives a path by itself, and knows none to the side. */
  @Test
  void aRobotAloneGoesNotSideways() {
    String reason = "Only a leader that can go sideways shifts its group; send segments without u.";
    Segment shift = Segment.shift(0.1, 1);
    assertTrue(server.hello().shifts());
    assertEquals(reason, server.rejectReason(driveOf(1, shift)));
    server.assertAccepted(driveOf(2, METRE));
    assertEquals(reason, server.rejectReason(new Extend(3, 2, 1, List.of(shift), 2, true)));
  }

  @Test
  void releasedLiesWithinTheSegments() {
    assertEquals("Of 1 segments 2 cannot be released.", server.rejectReason(released(1, 2, METRE)));
    assertEquals(
        "Of 1 segments -1 cannot be released.", server.rejectReason(released(2, -1, METRE)));
  }

  @Test
  void phaseAndTaskBelongTogether() {
    assertEquals(
        "The phase 4 is not one of 0 to 3.",
        server.rejectReason(TestServer.drive(1, 5L, 4, Rig.START, List.of(METRE))));
    assertEquals(
        "A drive without a task has phase 0, and one for a task has phase 1, 2 or 3.",
        server.rejectReason(TestServer.drive(2, null, 1, Rig.START, List.of(METRE))));
    assertEquals(
        "A drive without a task has phase 0, and one for a task has phase 1, 2 or 3.",
        server.rejectReason(TestServer.drive(3, 5L, 0, Rig.START, List.of(METRE))));
  }

  @Test
  void refusedDriveMovesNothingAndIsNoLastNumber() {
    server.rejectReason(driveOf(9, new Segment(2, 0, 1)));
    server.advance(Duration.ofSeconds(1));

    assertEquals(Rig.START, server.pose());
    assertEquals(0, rig.connect().hello().lastSeq());
  }

  @Test
  void extendReplacesNothingThatIsReleased() {
    server.assertAccepted(released(1, 2, METRE, METRE, METRE));

    assertEquals(
        "Segments can be replaced from 2 (what is released stays) to 3, not from 1.",
        server.rejectReason(new Extend(2, 1, 1, List.of(METRE), 2, true)));
    assertEquals(
        "Segments can be replaced from 2 (what is released stays) to 3, not from 4.",
        server.rejectReason(new Extend(3, 1, 4, List.of(METRE), 2, true)));
    assertEquals(
        "What is released only grows: from 2 to at most 4, not 5.",
        server.rejectReason(new Extend(4, 1, 3, List.of(METRE), 5, true)));
    assertEquals(
        "What is released only grows: from 2 to at most 4, not 1.",
        server.rejectReason(new Extend(5, 1, 3, List.of(METRE), 1, true)));
    assertEquals(
        "Segment 3 has 0.9 m/s; this robot drives at most 0.5 m/s.",
        server.rejectReason(new Extend(6, 1, 3, List.of(new Segment(0.9, 0, 1)), 3, true)));
    server.assertAccepted(new Extend(7, 1, 2, List.of(METRE), 3, true));
  }

  @Test
  void releaseOnlyGrows() {
    server.assertAccepted(released(1, 1, METRE, METRE));

    assertEquals(
        "What is released only grows: from 1 to at most 2, not 0.",
        server.rejectReason(new Release(2, 1, 0)));
    assertEquals(
        "What is released only grows: from 1 to at most 2, not 3.",
        server.rejectReason(new Release(3, 1, 3)));
    server.assertAccepted(new Release(4, 1, 1));
    server.assertAccepted(new Release(5, 1, 2));
    assertEquals(2, server.state().released());
  }

  @Test
  void driveThatIsNoMoreCannotGrow() {
    assertEquals(
        "There is no drive 7 any more; the robot has none.",
        server.rejectReason(new Release(1, 7, 1)));
    server.assertAccepted(driveOf(8, METRE));
    assertEquals(
        "There is no drive 7 any more; the robot has drive 8.",
        server.rejectReason(new Extend(9, 7, 0, List.of(METRE), 1, true)));
  }

  @Test
  void endlessTrajectoryIsRejected() {
    server.assertAccepted(released(1, 0, METRE));
    List<Segment> many = Collections.nCopies(500, METRE);
    String reason = "";
    for (int i = 0; i < 201 && reason.isEmpty(); i++) {
      Extend more = new Extend(2 + i, 1, 1 + 500 * i, many, 0, false);
      reason = i < 199 ? acceptedOrFailed(more) : server.rejectReason(more);
    }

    // 1 + 199 * 500 segments are a drive, 500 more are not
    assertEquals("A drive has at most 100000 segments.", reason);
  }

  private String acceptedOrFailed(Extend extend) {
    server.assertAccepted(extend);
    return "";
  }

  @Test
  void drivingRobotIsNotToldWhereItIs() {
    server.assertAccepted(driveOf(1, METRE));

    assertEquals(
        "A robot that drives cannot be told where it is; send cancel first.",
        server.rejectReason(new Locate(2, new Pose(0, 0, 0))));
  }

  @Test
  void placeOffAnyMapIsRefused() {
    assertEquals(
        "The pose lies more than 100000 m from the map's origin.",
        server.rejectReason(new Locate(1, new Pose(1e9, 0, 0))));
    assertEquals(Rig.START, server.pose());
  }

  @Test
  void standingRobotTakesItsPlaceFromLocate() {
    server.assertAccepted(new Locate(1, new Pose(7, 8, 1.5)));
    rig.advance(Chassis.TICK);
    rig.advance(Duration.ofMillis(200));

    assertPose(new Pose(7, 8, 1.5), server.pose());
    server.assertAccepted(TestServer.drive(2, 5L, 1, new Pose(7, 8, 1.5), List.of(METRE)));
  }

  @Test
  void repeatedCommandIsAcknowledgedAndHasNoEffect() {
    server.assertAccepted(driveOf(4, METRE));
    server.assertAccepted(new Cancel(5, 5L));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, Duration.ofSeconds(3));

    assertEquals(new Ack(4), server.ask(driveOf(4, METRE)));
    assertEquals(new Ack(3), server.ask(driveOf(3, METRE)));
    server.advance(Duration.ofSeconds(1));
    assertEquals(Mode.IDLE, server.state().mode());
    assertFalse(server.state().drive() == 4);
  }

  @Test
  void pingIsNoLastNumber() {
    server.assertAccepted(driveOf(4, METRE));
    server.synchronise();

    assertEquals(4, rig.connect().hello().lastSeq());
  }

  static void assertPose(Pose expected, Pose actual) {
    assertEquals(expected.x(), actual.x(), 1e-9);
    assertEquals(expected.y(), actual.y(), 1e-9);
    assertEquals(expected.theta(), actual.theta(), 1e-9);
  }

  private static Drive driveOf(long seq, Segment... segments) {
    return TestServer.drive(seq, 5L, 1, Rig.START, List.of(segments));
  }

  private static Drive released(long seq, int count, Segment... segments) {
    return new Drive(seq, 5L, 1, Rig.START, List.of(segments), count, true, 0);
  }

  @Test
  void helloIntroducesTheRobot() {
    var hello = server.hello();

    assertEquals("r1", hello.robot());
    assertEquals(1, hello.version());
    assertEquals(5, hello.maxLoad());
    assertEquals(0.5, hello.maxSpeed());
    assertEquals(0.255, hello.footprint());
    assertTrue(hello.localised());
    assertEquals(Rig.START, hello.pose());
    assertInstanceOf(Ack.class, server.ask(new Release(-1, 0, 0)), "a number below the first");
  }
}
