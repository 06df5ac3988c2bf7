package org.toqa.agent;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** Three daemons that carry one load, over real sockets, seen from their server. */
class FormationTest {

  private static final Segment STRAIGHT = new Segment(0.25, 0, 8);
  private static final Segment LEFT = new Segment(0.2, 0.25, Math.PI / 2 / 0.25); // radius 0.8 m

  /** Within which time a group stops by contract, milliseconds. */
  private static final long STAND_MILLIS = 800;

  @TempDir Path folder;
  private FormationRig group;

  @BeforeEach
  void open() {
    group = new FormationRig(folder);
  }

  @AfterEach
  void close() {
    group.close();
    group.truth().assertApart();
  }

  @Test
  void formationDrivesTheLeadersTrajectoryInShapeAndEachReportsDone() {
    List<Segment> segments = List.of(STRAIGHT, LEFT, STRAIGHT);
    group.startFormation(segments);
    State onTheWay = group.server(1).awaitState(s -> s.twist().v() > 0.2);
    assertEquals(Role.FOLLOWER, onTheWay.role());
    assertEquals(Mode.FOLLOWING, onTheWay.mode());
    assertEquals(0, requireNonNull(onTheWay.placeError()), FormationRig.TOLERANCE);
    State leader = group.server(0).awaitState(s -> true);
    assertEquals(Role.LEADER, leader.role());
    assertNull(leader.placeError());

    // each of the followers' flags has the number of its order to follow
    assertEquals(new Done(FormationRig.TASK, 2, 2), group.server(0).awaitDone());
    assertEquals(new Done(FormationRig.TASK, 2, 1), group.server(1).awaitDone());
    assertEquals(new Done(FormationRig.TASK, 2, 1), group.server(2).awaitDone());

    Pose goal = new Trajectory(FormationRig.LEADER, segments).end();
    assertNear(goal, standing(0));
    assertNear(FormationRig.SHAPE.followersAt(goal).get(0), standing(1));
    assertNear(FormationRig.SHAPE.followersAt(goal).get(1), standing(2));
    group.truth().assertInShape(FormationRig.TOLERANCE);
    // wheels that slip by 1 % at each step; 5.3 m of way
    group.truth().assertLeaderAt(goal, 0.05);
  }

  @Test
  void groupIsLedSidewaysInShape() {
    List<Segment> segments =
        List.of(new Segment(0.25, 0, 2), Segment.shift(0.1, 6), new Segment(0.25, 0, 2));
    group.startFormation(segments);
    State aside = group.server(2).awaitState(s -> s.twist().u() > 0.08);
    assertEquals(0, aside.twist().v(), 0.03);
    assertEquals(FormationRig.LEADER.theta(), aside.pose().theta(), 0.05);

    assertEquals(new Done(FormationRig.TASK, 2, 2), group.server(0).awaitDone());
    Pose goal = new Trajectory(FormationRig.LEADER, segments).end();
    assertNear(goal, standing(0));
    assertNear(FormationRig.SHAPE.followersAt(goal).get(0), standing(1));
    assertNear(FormationRig.SHAPE.followersAt(goal).get(1), standing(2));
    group.truth().assertInShape(FormationRig.TOLERANCE);
    group.truth().assertLeaderAt(goal, 0.03);
  }

  @Test
  void followerThatIsHeldStopsTheGroupUntilItIsLetGoOn() {
    group.startFormation(List.of(STRAIGHT));
    group.server(0).awaitState(s -> s.twist().v() > 0.2);
    group.server(2).assertAccepted(new Hold(5));
    awaitStopped("r3 cannot follow");
    group.server(0).awaitState(s -> s.twist().v() < 0.01);
    group.server(1).awaitState(s -> s.twist().v() < 0.01);

    group.server(2).assertAccepted(new Resume(6));
    group.server(0).awaitState(s -> s.errors().isEmpty() && s.twist().v() > 0.2);
    assertEquals(new Done(FormationRig.TASK, 2, 2), group.server(0).awaitDone());
  }

  @Test
  void groupStandsInTimeWhenAFollowerIsGone() {
    group.startFormation(List.of(STRAIGHT, LEFT));
    group.server(0).awaitState(s -> s.twist().v() > 0.2);
    long gone = group.kill(2);

    awaitStopped("r3 does not answer");
    assertStandsSince(gone + STAND_MILLIS, 0);
    assertStandsSince(gone + STAND_MILLIS, 1);
  }

  @Test
  void followersStandInTimeWhenTheirLeaderIsGone() {
    group.startFormation(List.of(STRAIGHT, LEFT));
    group.server(1).awaitState(s -> s.twist().v() > 0.2);
    long gone = group.kill(0);

    State lost = group.server(1).awaitState(s -> hasFault(s, "LEADER_LOST"));
    assertEquals(Mode.HOLDING, lost.mode());
    assertEquals(FormationRig.TASK, lost.task());
    assertStandsSince(gone + STAND_MILLIS, 1);
    assertStandsSince(gone + STAND_MILLIS, 2);
  }

  @Test
  void groupDrivesOnWhileItsServerIsAway() {
    group.startFormation(List.of(STRAIGHT, LEFT));
    State before = group.server(1).awaitState(s -> s.twist().v() > 0.2);
    group.servers().forEach(FormationServer::close);
    group.connectServers();

    State after = group.server(1).awaitState(s -> s.stamp() > before.stamp() + 2_000);
    assertEquals(Mode.FOLLOWING, after.mode());
    assertTrue(after.pose().distanceTo(before.pose()) > 0.3, "it drove on");
    assertEquals(new Done(FormationRig.TASK, 2, 1), group.server(1).awaitDone());
  }

  @Test
  void cancelOfTheLeaderIsNoEndOfTheFormation() {
    group.startFormation(List.of(STRAIGHT, LEFT));
    group.server(1).awaitState(s -> s.twist().v() > 0.2);
    group.server(0).assertAccepted(new Cancel(9, FormationRig.TASK));

    group.server(1).awaitState(s -> hasFault(s, "LEADER_LOST"));
    assertEquals(List.of(), group.server(1).dones());
    group.server(1).assertAccepted(new Cancel(9, FormationRig.TASK));
    State free = group.server(1).awaitState(s -> s.mode() == Mode.IDLE);
    assertEquals(Role.ALONE, free.role());
  }

  @Test
  void ordersThatCannotBeRightAreRefused() {
    FormationServer server = group.server(1);
    Vec2 beside = new Vec2(-0.5, 0);

    assertEquals(
        "r2 cannot follow itself.",
        server.rejectReason(new Follow(1, 7, "r2", null, beside, 0.05, null)));
    assertEquals(
        "The place is 0.05 m from the leader; it must be from 0.13 to 50 m.",
        server.rejectReason(new Follow(2, 7, "r1", null, new Vec2(0.05, 0), 0.05, null)));
    assertEquals(
        "The tolerance must be more than 0 and at most 0.5 m, not 0.000.",
        server.rejectReason(new Follow(3, 7, "r1", null, beside, 0, null)));
    assertEquals(
        "A leader has 1 to 11 followers, not 0.",
        server.rejectReason(new Lead(4, 7, 0.05, List.of(), null)));
    FormationServer leader = group.server(0);
    Follower follower = new Follower("r2", "127.0.0.1", group.port(1), null);
    leader.assertAccepted(new Lead(1, 7, 0.05, List.of(follower), null));
    assertEquals(
        "Segment 0 goes sideways, so its v and w must be 0, not 0.1 and 0.0.",
        leader.rejectReason(
            new Drive(
                2, 7L, 2, FormationRig.LEADER, List.of(new Segment(0.1, 0, 1, 0.1)), 1, true, 0)));
    assertEquals(
        "Segment 0 goes sideways by 0.6 m/s; this robot drives at most 0.5 m/s.",
        leader.rejectReason(
            new Drive(3, 7L, 2, FormationRig.LEADER, List.of(Segment.shift(0.6, 1)), 1, true, 0)));
    server.assertAccepted(new Follow(5, 7, "r1", null, beside, 0.05, null));
    assertEquals(
        "The robot follows r1; wait for the formation's end or send cancel.",
        server.rejectReason(
            new Drive(6, 7L, 2, FormationRig.LEADER, List.of(STRAIGHT), 1, true, 0)));
  }

  private Pose standing(int robot) {
    return group.server(robot).awaitState(s -> s.mode() == Mode.IDLE).pose();
  }

  /** On a busy machine the group may first have stopped for a moment for another reason. */
  private void awaitStopped(String reason) {
    Fault stopped = new Fault("FORMATION_STOPPED", "The group has stopped: " + reason + ".");
    group.server(0).awaitState(s -> s.errors().contains(stopped));
  }

  /** It is heard for a while longer, and in that time no more than settles. */
  private void assertStandsSince(long millis, int robot) {
    group.server(robot).awaitState(s -> s.stamp() > millis + 1_000);
    List<State> later =
        group.server(robot).states().stream().filter(s -> s.stamp() >= millis).toList();
    Pose stopped = later.getFirst().pose();
    for (State state : later) {
      assertEquals(0, state.twist().v(), 0.03, () -> "at " + state);
      assertEquals(0, stopped.distanceTo(state.pose()), 0.02, () -> "at " + state);
    }
  }

  private static boolean hasFault(State state, String code) {
    return state.errors().stream().map(Fault::code).anyMatch(code::equals);
  }

  private static void assertNear(Pose expected, Pose actual) {
    assertTrue(expected.distanceTo(actual) < 0.01, actual + " is not near " + expected);
  }
}
