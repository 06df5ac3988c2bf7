package org.toqa.fleet;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.mission.TaskState;
import org.toqa.notices.Condition;
import org.toqa.notices.Conditions;
import org.toqa.notices.NoticeKind;

/** Robots that are connected, and do not do what they are told or tell nothing of themselves. */
class DisobedientRobotTest extends HallFleetTest {
  private static final String FAULT = "The battery of the state is not from 0 to 1.";
  private static final String REFUSES = "refuses to drive: No";
  private static final String IS_DEAF = "does not answer commands";

  @Test
  void aRobotWhoseReportsCannotBeUnderstoodIsLostThoughItAnswers() throws Exception {
    long task = beginWithTwo();
    scriptedRobot("r1").setStuck(true);
    scriptedRobot("r1").setStateFault(FAULT);

    until(view -> robot(view, "r1").state() == RobotState.LOST);
    assertEquals(
        "What r1 reports of itself cannot be understood: " + FAULT + " Correct its program.",
        String.valueOf(robot(latest(), "r1").unreachable()));
    assertNotice(NoticeKind.ROBOT_LOST, FAULT);
    until(view -> task(view, task).needs() != null);
    Instant asked = stage.now;
    untilOfOther(task);
    assertTrue(stage.now.isBefore(asked.plus(FleetStage.REASSIGN_AFTER)));

    scriptedRobot("r1").setStateFault(null);
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    assertNull(robot(latest(), "r1").unreachable());
  }

  @Test
  void aTaskThatARobotRefusesGoesToAnotherAndItsRobotIsLeftOutForAWhile() throws Exception {
    scriptedRobot("r1").refuse(Drive.class::isInstance);
    long task = beginWithTwo();
    Instant begun = stage.now;

    untilOfOther(task);
    assertTrue(stage.now.isBefore(begun.plusSeconds(10)), "five refusals");
    assertLeftOut(REFUSES);
    assertNotice(NoticeKind.ROBOT_ERROR, REFUSES);
    stage.pass(Duration.ofMinutes(4));
    assertLeftOut(REFUSES);

    scriptedRobot("r1").refuse(_ -> false);
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    assertTrue(stage.now.isBefore(begun.plusSeconds(320)), "tried again after five minutes");
    long next = submit(order(1));
    until(view -> task(view, next).robots().equals(List.of("r1")));
    until(view -> task(view, next).state() == TaskState.CARRYING);
  }

  @Test
  void whereThereIsNoOtherAPersonIsAskedAndMayPutTheRobotBack() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    scriptedRobot("r1").refuse(Drive.class::isInstance);
    long task = submit(order(1));

    until(view -> robot(view, "r1").state() == RobotState.ERROR);
    assertLeftOut(REFUSES);
    until(view -> task(view, task).state() == TaskState.QUEUED);
    until(view -> !waitReason(view, task).isEmpty());
    String waits = waitReason(latest(), task);
    stage.pass(Duration.ofMinutes(1));
    assertLeftOut(REFUSES);
    assertEquals(waits, waitReason(latest(), task));
    assertNotice(NoticeKind.ROBOT_ERROR, REFUSES);

    scriptedRobot("r1").refuse(_ -> false);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    accepted(stage.fleet.putInService("r1", "Max"));
    Instant back = stage.now;
    until(view -> task(view, task).state() == TaskState.CARRYING);
    assertTrue(stage.now.isBefore(back.plusSeconds(60)));
  }

  @Test
  void whoHasRefusedOnceAndIsBarredThenSaysWhatBarsItsWay() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    scriptedRobot("r1").refuse(command -> isOfPhase(command, 2));
    long task = submit(new Where.Point(new Vec2(3.5, 1.5)), new Where.Station("East"));
    until(view -> waitReason(view, task).contains("refused"));

    scriptedRobot("r2").shove(DOOR.minus(EAST));
    until(view -> requireNonNull(robot(view, "r2").telemetry().pose()).x() < EAST.x() - 1);
    scriptedRobot("r2").fallSilent();
    scriptedRobot("r1").refuse(_ -> false);

    until(view -> waitReason(view, task).contains("r2"));
    scriptedRobot("r2").speakAgain();
    accepted(stage.fleet.putInService("r2", "Max"));
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aRobotThatRefusesWithTheLoadOnBoardAsksAPerson() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    long task = submit(order(1));
    until(
        view -> task(view, task).state() == TaskState.TO_OBJECT && scriptedRobot("r1").isDriving());
    scriptedRobot("r1").refuse(command -> isOfPhase(command, 2));

    until(view -> task(view, task).needs() != null);
    assertAsked(task, "r1 " + REFUSES);
  }

  @Test
  void aFollowerThatRefusesToFollowAsksAPerson() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    scriptedRobot("r1").refuse(Follow.class::isInstance); // whichever of them follows
    scriptedRobot("r2").refuse(Follow.class::isInstance);
    long task = submit(orderForSeveral(8));

    until(view -> task(view, task).needs() != null);
    assertAsked(task, REFUSES);
  }

  @Test
  void aLeaderThatRefusesToLeadDoesNotLeaveWithoutItsFollowersAndAsksAPerson() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    scriptedRobot("r1").refuse(Lead.class::isInstance); // whichever of them leads
    scriptedRobot("r2").refuse(Lead.class::isInstance);
    long task = submit(orderForSeveral(8));

    until(view -> task(view, task).needs() != null);
    assertAsked(task, REFUSES);
    for (String name : List.of("r1", "r2")) {
      assertTrue(scriptedRobot(name).obeyed().stream().noneMatch(command -> isOfPhase(command, 2)));
    }
  }

  @Test
  void aConnectionOverWhichNothingIsHeardIsMadeAnew() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    scriptedRobot("r1").goDeaf(true);
    long task = submit(order(1));
    Instant begun = stage.now;

    until(view -> scriptedRobot("r1").isDriving());
    assertTrue(stage.now.isBefore(begun.plusSeconds(15)));
    until(view -> task(view, task).state() == TaskState.CARRYING);
  }

  @Test
  void aRobotThatAnswersNothingLosesItsTaskAndIsToldSo() throws Exception {
    scriptedRobot("r1").goDeaf(false);
    long task = beginWithTwo();
    Instant begun = stage.now;

    untilOfOther(task);
    assertTrue(stage.now.isBefore(begun.plusSeconds(30)), "twice ten seconds");
    assertLeftOut(IS_DEAF);
    assertNotice(NoticeKind.ROBOT_ERROR, IS_DEAF);
    for (int i = 0; i < 20; i++) {
      stage.pass(Duration.ofSeconds(5));
      assertLeftOut(IS_DEAF);
    }

    untilDone(task);
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    accepted(stage.fleet.putInService("r1", "Max"));
    long next = submit(order(1));
    until(view -> task(view, next).robots().equals(List.of("r1")));
    Instant again = stage.now;
    until(view -> robot(view, "r1").state() == RobotState.ERROR);
    assertTrue(stage.now.isBefore(again.plusSeconds(15)));
  }

  /** r1, the nearer one, has the task. */
  private long beginWithTwo() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(
        view ->
            robot(view, "r1").state() == RobotState.IDLE
                && robot(view, "r2").state() == RobotState.IDLE);
    long task = submit(order(1));
    until(view -> task(view, task).robots().equals(List.of("r1")));
    return task;
  }

  private void untilDone(long task) throws InterruptedException {
    until(
        view -> view.tasks().stream().noneMatch(one -> one.id() == task && !one.state().isEnded()));
  }

  private void untilOfOther(long task) throws InterruptedException {
    until(view -> task(view, task).robots().equals(List.of("r2")));
  }

  private static boolean isOfPhase(Command command, int phase) {
    return command instanceof Drive drive && drive.phase() == phase;
  }

  private FleetSnapshot latest() {
    return stage.fleet.snapshots().latest();
  }

  private void assertLeftOut(String clause) {
    RobotView robot = robot(latest(), "r1");
    assertEquals(RobotState.ERROR, robot.state());
    assertEquals(
        "Gets no tasks, since it %s. See to it; it is tried again after 5 minutes, and at once when it was taken out of service and put back."
            .formatted(clause),
        robot.work().doing().english());
  }

  private void assertNotice(NoticeKind kind, String part) {
    List<Condition> told = Conditions.of(latest());
    assertTrue(
        told.stream().anyMatch(one -> one.kind() == kind && one.text().english().contains(part)),
        told::toString);
  }

  private void assertAsked(long task, String part) {
    String question = requireNonNull(task(latest(), task).needs()).question().english();
    assertTrue(question.contains(part), question);
    assertEquals(TaskState.CARRYING, task(latest(), task).state());
    assertNotice(NoticeKind.TASK_QUESTION, part);
  }
}
