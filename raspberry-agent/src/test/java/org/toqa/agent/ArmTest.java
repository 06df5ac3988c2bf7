package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedArm;
import org.toqa.agent.config.ArmConfig;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmAction;
import org.toqa.arm.ArmStep;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.ActEnd;
import org.toqa.link.message.AgentMessage.Acted;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Clear;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Frame;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.motion.Segment;

/** A robot's arm over the link: the real daemon and a simulated arm. */
class ArmTest {
  private static final Duration MINUTE = Duration.ofMinutes(1);
  static final Arm ARM =
      new Arm(
          0.3,
          0.25,
          new Pose(0.05, 0, 0),
          new JointLimits(-2.5, 2.5, 1.5, 4),
          new JointLimits(-2.8, 2.8, 2, 5),
          2,
          new JointAngles(2.2, -2.7));

  /** In front of where the robot stands, which is at (2, 3) and faces east. */
  private static final Vec2 BOX = new Vec2(2.45, 3.1);

  @TempDir Path folder;
  private Rig rig;
  private TestServer server;

  @BeforeEach
  void start() {
    rig = new Rig(folder, new ArmConfig(ARM, null));
    server = rig.connect();
  }

  @AfterEach
  void end() {
    rig.close();
  }

  private static Act pick(long seq) {
    return new Act(seq, 5, 1, ArmAction.PICK, Frame.MAP, BOX, 1.5);
  }

  private static Act place(long seq) {
    return new Act(seq, 5, 2, ArmAction.PLACE, Frame.ROBOT, new Vec2(0.4, -0.1), 1.5);
  }

  private static ArmState arm(State state) {
    return Objects.requireNonNull(state.arm());
  }

  private Acted runToItsEnd(TestServer of) {
    of.advanceUntil(state -> arm(state).act() == null, MINUTE);
    return of.received(Acted.class).getLast();
  }

  private static Acted done(Act act, @Nullable Double weight) {
    return new Acted(act.seq(), act.task(), act.phase(), act.action(), null, weight);
  }

  @Test
  void helloTellsTheArm() {
    assertEquals(ARM, server.hello().arm());
    assertNull(server.hello().act());
    assertEquals(ARM.rest(), arm(server.state()).joints());
  }

  @Test
  void picksUpWeighsTellsEachStepAndPlaces() {
    server.assertAccepted(pick(1));
    assertEquals(done(pick(1), 1.5), runToItsEnd(server));
    List<ArmStep> steps =
        server.received(State.class).stream()
            .map(state -> arm(state).step())
            .filter(Objects::nonNull)
            .distinct()
            .toList();
    assertEquals(ArmAction.PICK.steps(), steps);
    assertEquals(1.5, arm(server.state()).load());

    server.assertAccepted(place(2));
    assertEquals(done(place(2), null), runToItsEnd(server));
    assertNull(arm(server.state()).load());
    assertEquals(0, arm(server.state()).joints().minus(ARM.rest()).largest(), 0.01);
  }

  @Test
  void handClosesWhereTheBoxIsOnTheMap() {
    server.assertAccepted(pick(1));
    State grasping = server.advanceUntil(s -> arm(s).step() == ArmStep.GRASP, MINUTE);
    Vec2 hand = ARM.handAt(arm(grasping).joints());
    Vec2 onMap = grasping.pose().compose(new Pose(hand.x(), hand.y(), 0)).position();
    assertEquals(0, onMap.distanceTo(BOX), 0.01);
  }

  @Test
  void endIsToldAgainUntilItIsAcknowledgedAlsoByTheNextDaemon() {
    server.assertAccepted(pick(1));
    runToItsEnd(server);
    int told = server.received(Acted.class).size();
    server.advance(Duration.ofMillis(2_500));
    assertEquals(told + 2, server.received(Acted.class).size());
    rig.restart();
    TestServer again = rig.connect();
    assertEquals(new ActEnd(1, 5, 1, ArmAction.PICK, null, 1.5), again.hello().acted());
    again.send(new ServerMessage.AckActed(1));
    again.advance(Duration.ofMillis(2_500));
    int before = again.received(Acted.class).size();
    again.advance(Duration.ofMillis(2_500));
    assertEquals(before, again.received(Acted.class).size());
    rig.restart();
    assertNull(rig.connect().hello().acted());
  }

  @Test
  void repeatedCommandHasNoFurtherEffect() {
    server.assertAccepted(pick(3));
    runToItsEnd(server);
    server.send(new ServerMessage.AckActed(3));
    server.assertAccepted(pick(3));
    server.advance(Duration.ofSeconds(3));
    assertNull(arm(server.state()).act());
  }

  @Test
  void placeOutOfReachEndsTheActWithAReason() {
    Act far = new Act(1, 5, 1, ArmAction.PICK, Frame.MAP, new Vec2(4, 3), 1);
    server.assertAccepted(far);
    server.advance(Duration.ofMillis(100));
    Acted acted = server.received(Acted.class).getLast();
    assertEquals("TOO_FAR", Objects.requireNonNull(acted.failure()).code());
    assertEquals(ARM.rest(), arm(server.state()).joints());
  }

  @Test
  void whatItRefusesItSaysWhy() {
    assertEquals(
        "The target must be within 100 km, and the load must not be less than 0 kg.",
        server.rejectReason(new Act(1, 5, 1, ArmAction.PICK, Frame.MAP, new Vec2(1e9, 0), 1)));
    assertEquals(
        "The phase is 7; an act has phase 1 to 3.",
        server.rejectReason(new Act(2, 5, 7, ArmAction.PICK, Frame.MAP, BOX, 1)));
    server.assertAccepted(pick(3));
    assertEquals(
        "The arm has not ended act 3; wait for its end or send cancel.",
        server.rejectReason(place(4)));
    assertEquals(
        "The arm has not ended act 3; wait for its end or send cancel.",
        server.rejectReason(TestServer.drive(5, 5L, 2, Rig.START, List.of())));
    runToItsEnd(server);
    assertEquals(
        "The robot works for task 5, not for task 6.",
        server.rejectReason(new Act(6, 6, 1, ArmAction.PICK, Frame.MAP, BOX, 1)));
  }

  @Test
  void holdStopsTheArmOnItsWayAndItGoesOnFromThere() {
    server.assertAccepted(pick(1));
    server.advance(Duration.ofMillis(700));
    server.assertAccepted(new Hold(2));
    server.advance(Duration.ofMillis(600));
    JointAngles stand = arm(server.state()).joints();
    assertNotEquals(ARM.rest(), stand);
    server.advance(Duration.ofSeconds(5));
    assertEquals(stand, arm(server.state()).joints());
    assertEquals(ArmStep.REACH, arm(server.state()).step());
    server.assertAccepted(new Resume(3));
    assertEquals(done(pick(1), 1.5), runToItsEnd(server));
  }

  /** Its commands have the numbers 1 and 2. */
  private void cancelWithArmOut() {
    server.assertAccepted(pick(1));
    server.advance(Duration.ofMillis(900));
    server.assertAccepted(new Cancel(2, 5L));
    server.advance(Duration.ofSeconds(2));
  }

  @Test
  void cancelledArmStandsAndIsFoldedBeforeTheRobotDrives() {
    cancelWithArmOut();
    JointAngles stand = arm(server.state()).joints();
    assertTrue(stand.minus(ARM.rest()).largest() > 0.1);
    assertNull(arm(server.state()).act());
    assertEquals(List.of(), server.received(Acted.class));
    server.assertAccepted(TestServer.drive(3, 6L, 1, Rig.START, List.of(new Segment(0.25, 0, 4))));
    server.advance(Duration.ofMillis(300));
    assertEquals(Rig.START, server.pose());
    server.advanceUntil(state -> state.mode() == Mode.IDLE, MINUTE);
    assertEquals(3, server.pose().x(), 0.005);
    assertEquals(0, arm(server.state()).joints().minus(ARM.rest()).largest(), 0.01);
  }

  /** In each step of picking up: nothing is dropped, and nothing is grasped twice. */
  @Test
  void daemonThatIsRestartedInTheMidstGoesOnWhenItIsToldAnew() {
    long seq = 0;
    for (ArmStep step : ArmAction.PICK.steps()) {
      TestServer now = seq == 0 ? server : rig.connect();
      now.assertAccepted(pick(++seq));
      now.advanceUntil(state -> arm(state).step() == step, MINUTE);
      JointAngles before = arm(now.state()).joints();
      rig.restart();
      TestServer again = rig.connect();
      Hello hello = again.hello();
      assertNull(hello.act());
      assertNull(hello.acted());
      assertEquals(5L, hello.task());
      assertEquals("RESTARTED", again.state().errors().getFirst().code());
      again.advance(Duration.ofSeconds(1));
      assertEquals(0, arm(again.state()).joints().minus(before).largest(), 0.1);
      again.assertAccepted(pick(++seq));
      assertEquals(List.of(), again.state().errors());
      assertEquals(done(pick(seq), 1.5), runToItsEnd(again));
      again.assertAccepted(place(++seq));
      assertNull(runToItsEnd(again).failure());
      again.send(new ServerMessage.AckActed(seq));
      again.synchronise();
    }
  }

  @Test
  void boxThatIsHeavierThanTheArmLiftsIsLetGo() {
    ((SimulatedArm) rig.body().arm().orElseThrow()).setBoxWeight(2.5);
    server.assertAccepted(pick(1));
    Acted acted = runToItsEnd(server);
    assertEquals("TOO_HEAVY", Objects.requireNonNull(acted.failure()).code());
    assertEquals(2.5, acted.weight());
    assertNull(arm(server.state()).load());
  }

  @Test
  void armThatDoesNotMoveIsToldAndStands() {
    SimulatedArm body = (SimulatedArm) rig.body().arm().orElseThrow();
    server.assertAccepted(pick(1));
    server.advance(Duration.ofMillis(500));
    body.setStuck(true);
    assertEquals("STALLED", Objects.requireNonNull(runToItsEnd(server).failure()).code());
    body.setStuck(false);
    assertFalse(server.state().mode() == Mode.ERROR);
  }

  @Test
  void armThatDoesNotComeToItsRestIsToldAndTriedAgainWhenAPersonSaysSo() {
    SimulatedArm body = (SimulatedArm) rig.body().arm().orElseThrow();
    cancelWithArmOut();
    body.setStuck(true);
    JointAngles held = arm(server.state()).joints();
    List<Segment> path = List.of(new Segment(0.25, 0, 4));
    server.assertAccepted(TestServer.drive(3, 6L, 1, Rig.START, path));
    State stopped = server.advanceUntil(state -> state.mode() == Mode.ERROR, MINUTE);
    assertEquals("ARM_STALLED", stopped.errors().getFirst().code());
    assertTrue(stopped.errors().getFirst().clearable());
    body.setStuck(false);
    server.advance(Duration.ofSeconds(10));
    assertEquals(held, arm(server.state()).joints()); // it does not push again by itself
    assertEquals(Rig.START, server.pose());

    server.assertAccepted(new Clear(4, List.of("ARM_STALLED")));
    server.advance(Duration.ofMillis(100));
    assertEquals(List.of(), server.state().errors());
    assertEquals(0, server.state().drive());
    assertEquals(6L, server.state().task());
    server.assertAccepted(TestServer.drive(5, 6L, 1, Rig.START, path));
    server.advanceUntil(state -> state.mode() == Mode.IDLE, MINUTE);
    assertEquals(3, server.pose().x(), 0.005);
  }

  @Test
  void followerFoldsItsArmBeforeItFollows() {
    cancelWithArmOut();
    server.assertAccepted(new Follow(3, 6, "r9", null, new Vec2(-0.5, 0), 0.5, null));
    server.advanceUntil(
        state -> arm(state).joints().minus(ARM.rest()).largest() < 0.01, Duration.ofSeconds(10));
  }

  @Test
  void robotWithoutAnArmRefuses() {
    try (Rig without = new Rig(folder.resolve("none"))) {
      assertNull(without.connect().hello().arm());
      assertEquals("The robot has no arm.", without.connect().rejectReason(pick(1)));
    }
  }
}
