package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** How a robot drives, seen from its server. */
class DrivingTest extends ConnectedRobotTest {
  @Test
  void trajectoryOfTwentyMetresEndsWhereItWasPlanned() {
    // turn, straight, arc left, straight, arc right ... as the fitter makes them, at 0.25 m/s
    double radius = 0.15 / Math.tan(Math.PI / 8);
    double rate = 0.25 / radius;
    Segment left = new Segment(0.25, rate, Math.PI / 4 / rate);
    Segment right = new Segment(0.25, -rate, Math.PI / 4 / rate);
    Segment straight = new Segment(0.25, 0, 9.2); // 2.3 m
    List<Segment> segments =
        List.of(
            new Segment(0, 1.5, Math.PI / 2 / 1.5),
            straight,
            left,
            straight,
            right,
            straight,
            right,
            straight,
            right,
            straight,
            left,
            straight,
            left,
            straight,
            straight,
            straight);
    Trajectory planned = new Trajectory(Rig.START, segments);
    assertTrue(planned.length() > 20);

    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, segments));
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE.multipliedBy(3));

    assertNear(planned.end(), end.pose(), 0.002, 0.003);
  }

  @Test
  void robotStaysOnItsTrajectoryWhileItDrives() {
    Segment tightLeft = new Segment(0.225, 1.5, Math.PI / 2 / 1.5); // radius 0.15 m
    List<Segment> segments = List.of(METRE, tightLeft, METRE, new Segment(0, -1.5, 1), METRE);
    Trajectory planned = new Trajectory(Rig.START, segments);

    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, segments));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);

    double worst =
        server.received(State.class).stream()
            .mapToDouble(s -> distance(planned, s.pose()))
            .max()
            .orElseThrow();
    assertTrue(worst < 0.03, "off the path by " + worst + " m");
  }

  @Test
  void robotStandsAtTheEndOfWhatIsReleasedAndGoesOnWhenMoreIs() {
    server.assertAccepted(new Drive(1, 5L, 1, Rig.START, List.of(METRE, METRE, METRE), 1, true, 0));
    server.advance(Duration.ofSeconds(10));
    assertNear(ahead(1), server.pose(), 0.002, 0.003);
    assertEquals(0, server.state().twist().v(), 0.01);
    assertEquals(Mode.DRIVING, server.state().mode());
    assertEquals(1, server.state().segment());

    server.assertAccepted(new Release(2, 1, 3));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    assertNear(ahead(3), server.pose(), 0.002, 0.003);
  }

  @Test
  void robotNeverLeavesWhatIsReleased() {
    server.assertAccepted(new Drive(1, 5L, 1, Rig.START, List.of(METRE, METRE), 1, true, 0));
    server.advance(Duration.ofSeconds(10));

    double farthest =
        server.received(State.class).stream().mapToDouble(s -> s.pose().x()).max().orElseThrow();
    assertTrue(farthest < ahead(1).x() + 0.005, "came to " + farthest);
  }

  @Test
  void releaseInTimeLeavesTheSpeedAsItIs() {
    server.assertAccepted(new Drive(1, 5L, 1, Rig.START, List.of(METRE, METRE, METRE), 1, true, 0));
    server.advance(Duration.ofSeconds(2));
    server.assertAccepted(new Release(2, 1, 2));
    int before = server.received(State.class).size();
    server.advance(Duration.ofSeconds(4));

    List<State> driving = server.received(State.class);
    assertTrue(driving.size() >= before + 20, "five states a second");
    for (State state : driving.subList(before, driving.size())) {
      assertEquals(0.25, state.twist().v(), 0.03);
    }
  }

  @Test
  void extendBringsTheRestOfTheTrajectory() {
    server.assertAccepted(new Drive(1, 5L, 1, Rig.START, List.of(METRE), 1, false, 0));
    server.advance(Duration.ofSeconds(10));
    assertEquals(List.of(), server.received(Done.class), "an extend will bring the rest");

    server.assertAccepted(new Extend(2, 1, 1, List.of(METRE), 2, true));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    assertNear(ahead(2), server.pose(), 0.002, 0.003);
  }

  @Test
  void extendReplansWhatIsNotReleased() {
    Segment turn = new Segment(0, 1, Math.PI / 2);
    server.assertAccepted(new Drive(1, 5L, 1, Rig.START, List.of(METRE, METRE, METRE), 1, true, 0));
    server.advance(Duration.ofSeconds(1));
    server.assertAccepted(new Extend(2, 1, 1, List.of(turn), 2, true));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);

    Pose end = new Pose(Rig.START.x() + 1, Rig.START.y(), Math.PI / 2);
    assertNear(end, server.pose(), 0.002, 0.003);
  }

  @Test
  void driveWithoutSegmentsIsDoneWhereTheRobotStands() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of()));
    server.advance(Duration.ofMillis(500));

    assertEquals(new Done(5L, 1, 1), server.received(Done.class).getFirst());
  }

  @Test
  void holdStopsTheRobotOnItsTrajectoryAndResumeContinues() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE, METRE)));
    server.advance(Duration.ofSeconds(2));
    server.assertAccepted(new Hold(2));
    server.advance(Duration.ofSeconds(2));
    Pose held = server.pose();
    assertEquals(Mode.HOLDING, server.state().mode());
    server.advance(Duration.ofSeconds(10));
    assertNear(held, server.pose(), 0.003, 0.006);

    server.assertAccepted(new Resume(3));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    assertNear(ahead(2), server.pose(), 0.002, 0.003);
  }

  @Test
  void driveToAHeldRobotWaitsForResume() {
    server.assertAccepted(new Hold(1));
    server.assertAccepted(TestServer.drive(2, 5L, 1, Rig.START, List.of(METRE)));
    server.advance(Duration.ofSeconds(5));
    assertNear(Rig.START, server.pose(), 0.001, 0.001);
    assertEquals(Mode.HOLDING, server.state().mode());

    server.assertAccepted(new Resume(3));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    assertNear(ahead(1), server.pose(), 0.002, 0.003);
  }

  @Test
  void cancelledRobotStandsAndWorksForNothing() {
    server.assertAccepted(TestServer.drive(1, 5L, 2, Rig.START, List.of(METRE, METRE)));
    server.advance(Duration.ofSeconds(3));
    server.assertAccepted(new Cancel(2, 5L));
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, Duration.ofSeconds(3));

    assertNull(end.task());
    assertEquals(0, end.phase());
    assertEquals(0, end.drive());
    assertTrue(end.pose().x() < ahead(1).x(), "it did not drive on: " + end.pose());
    server.advance(Duration.ofSeconds(3));
    assertEquals(List.of(), server.received(Done.class));
    server.assertAccepted(TestServer.drive(3, null, 0, server.pose(), List.of(METRE)));
  }

  @Test
  void cancelOfAnotherTaskLeavesTheRobotAlone() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE)));
    server.assertAccepted(new Cancel(2, 6L));
    server.assertAccepted(new Cancel(3, null));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);

    assertEquals(new Done(5L, 1, 1), server.received(Done.class).getFirst());
  }

  @Test
  void doneIsRepeatedEverySecondUntilItIsAcknowledged() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of()));
    server.advance(Duration.ofMillis(4_500));
    // at once, and after 1, 2, 3 and 4 s
    assertEquals(5, server.received(Done.class).size());

    server.acknowledge(1);
    server.advance(Duration.ofSeconds(3));
    assertEquals(5, server.received(Done.class).size());
    assertEquals(5L, server.state().task(), "the task goes on with its next phase");
  }

  @Test
  void acknowledgementOfAnotherDriveIsNone() {
    server.assertAccepted(TestServer.drive(3, 5L, 1, Rig.START, List.of()));
    server.advance(Duration.ofMillis(500));
    server.acknowledge(2);
    server.advance(Duration.ofMillis(900));

    // at once, and after 1 s
    assertEquals(2, server.received(Done.class).size());
  }

  @Test
  void acknowledgedEndOfPhaseThreeEndsTheTask() {
    server.assertAccepted(TestServer.drive(1, 5L, 3, Rig.START, List.of()));
    server.advance(Duration.ofMillis(500));
    server.acknowledge(1);
    server.advance(Duration.ofMillis(500));

    assertNull(server.state().task());
    assertEquals(0, server.state().phase());
  }

  @Test
  void silentServerLetsTheRobotFinishWhatIsReleasedAndHold() {
    server.assertAccepted(new Drive(1, 5L, 1, Rig.START, List.of(METRE, METRE), 1, true, 0));
    rig.advance(Duration.ofSeconds(10));

    server.synchronise(); // now it is heard again, after the states of the silence
    List<State> states = server.received(State.class);
    State silent = states.get(states.size() - 2);
    assertEquals(Mode.HOLDING, silent.mode());
    assertNear(ahead(1), silent.pose(), 0.002, 0.003);
  }

  @Test
  void robotThatWaitedForASilentServerGoesOnWhenMoreIsReleased() {
    server.assertAccepted(new Drive(1, 5L, 1, Rig.START, List.of(METRE, METRE), 1, true, 0));
    rig.advance(Duration.ofSeconds(10));
    server.assertAccepted(new Release(2, 1, 2));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);

    assertNear(ahead(2), server.pose(), 0.002, 0.003);
  }

  @Test
  void silentServerHearsTheEndOfAPhaseLater() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE)));
    server.close();
    rig.advance(Duration.ofSeconds(20));

    TestServer again = rig.connect();
    assertEquals(new PhaseEnd(5L, 1, 1), again.hello().done());
    assertNear(ahead(1), again.hello().pose(), 0.002, 0.003);
  }

  private static Pose ahead(double metres) {
    return new Pose(Rig.START.x() + metres, Rig.START.y(), Rig.START.theta());
  }

  private static double distance(Trajectory trajectory, Pose pose) {
    double nearest = Double.POSITIVE_INFINITY;
    for (double t = 0; t <= trajectory.duration(); t += 0.01) {
      nearest = Math.min(nearest, trajectory.poseAt(t).distanceTo(pose));
    }
    return nearest;
  }

  static void assertNear(Pose expected, Pose actual, double metres, double radians) {
    assertTrue(
        expected.distanceTo(actual) <= metres
            && Math.abs(Angles.difference(expected.theta(), actual.theta())) <= radians,
        () -> "expected " + expected + ", was at " + actual);
  }
}
