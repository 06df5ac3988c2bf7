package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmAction;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.ActFailure;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Question;
import org.toqa.mission.Reply;
import org.toqa.mission.TaskState;

/** Tasks whose loads an arm picks up and puts down. */
class ArmFleetTest extends HallFleetTest {
  private static final Arm ARM =
      new Arm(
          0.4,
          0.4,
          new Pose(0, 0, 0),
          new JointLimits(-3, 3, 1, 2),
          new JointLimits(-3, 3, 1, 2),
          2,
          new JointAngles(2, -2.5));

  /** Beside the stations, which are at (0.5, 2.5) and (8.5, 2.5). */
  private static final ArmHandling HANDLING =
      new ArmHandling(new Vec2(0.5, 1.9), new Vec2(9.1, 2.5));

  private static final ActFailure NOTHING = new ActFailure("NOTHING_GRASPED", "Nothing.");

  @BeforeEach
  void giveArm() throws Exception {
    stage.add("r2", EAST, "P2");
    scriptedRobot("r1").setArm(ARM);
    stage.restart();
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
  }

  private static TaskOrder order(double load, @Nullable ArmHandling arm) {
    return new TaskOrder(
        "box",
        load,
        new Where.Station("West"),
        new Where.Station("East"),
        null,
        0,
        null,
        null,
        List.of(),
        List.of(),
        arm);
  }

  private long submitForArm() throws Exception {
    return submit(order(1, HANDLING));
  }

  private static TaskOrder only(double load, String... robots) {
    TaskOrder order = order(load, null);
    return new TaskOrder(
        "box", load, order.start(), order.goal(), null, 0, null, null, List.of(robots), List.of());
  }

  @Test
  void aTaskForRobotsWithAnArmWaitsForThoseAlone() throws Exception {
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    until(view -> robot(view, "r1").state() == RobotState.OUT_OF_SERVICE);

    long task = submit(only(1, "with:arm"));

    until(
        view ->
            "Only robots with an arm (here r1) may do this, and it is out of service."
                .equals(waitReason(view, task)));
    long next = submit(only(1, "with:arm"));
    accepted(stage.fleet.putInService("r1", "Max"));
    until(
        view ->
            ("Only robots with an arm (here r1) may do this, and it is working on task "
                    + task
                    + ".")
                .equals(waitReason(view, next)));
    until(view -> task(view, next).state() == TaskState.DONE);
    assertEquals(List.of("r1"), task(stage.fleet.snapshots().latest(), next).robots());
    assertEquals(List.of("with:arm"), stage.store.task(task).orElseThrow().task().onlyRobots());
  }

  @Test
  void theLastRobotWithAnArmGoesAndTheTaskNeedsAttention() throws Exception {
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    long task = submit(only(1, "with:arm"));

    accepted(stage.fleet.removeRobot("r1", "Max"));

    until(view -> task(view, task).blocked());
    assertEquals(
        "Only robots with an arm may do this, and there is no such robot on this floor. Order it"
            + " anew for others, or cancel it.",
        waitReason(stage.fleet.snapshots().latest(), task));
  }

  @Test
  void whatTheRobotsWithAnArmCannotCarryIsRefused() throws Exception {
    Answer<TaskView> answer = answer(stage.fleet.submit(only(6, "with:arm"), "Clara"));

    assertEquals(
        "The load weighs 6 kg; robots with an arm can carry 5 kg. Allow more or stronger robots, or"
            + " split the load.",
        assertInstanceOf(Answer.Rejected.class, answer).sentence().english());
  }

  @Test
  void oneOfSeveralAbilitiesIsEnough() throws Exception {
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    until(view -> robot(view, "r1").state() == RobotState.OUT_OF_SERVICE);

    long task = submit(only(1, "with:arm", "r2"));

    until(view -> task(view, task).robots().equals(List.of("r2")));
  }

  private Act awaitAct(ArmAction action) throws InterruptedException {
    until(
        _ ->
            Optional.ofNullable(scriptedRobot("r1").act())
                .filter(act -> act.action() == action)
                .isPresent());
    return Objects.requireNonNull(scriptedRobot("r1").act());
  }

  private void endAct() {
    scriptedRobot("r1").endAct(null, 1.0);
  }

  private void untilState(long task, TaskState state) throws InterruptedException {
    until(view -> task(view, task).state() == state);
  }

  private Question awaitQuestion(long task) throws InterruptedException {
    until(view -> task(view, task).needs() != null);
    return Objects.requireNonNull(task(stage.fleet.snapshots().latest(), task).needs());
  }

  @Test
  void phaseEndsWhenTheArmHasDoneItsPart() throws Exception {
    long task = submitForArm();
    Act pick = awaitAct(ArmAction.PICK);
    assertEquals(HANDLING.pick(), pick.target());
    assertEquals(1, pick.phase());
    assertEquals(task, pick.task());
    assertEquals(TaskState.TO_OBJECT, task(stage.fleet.snapshots().latest(), task).state());
    endAct();
    untilState(task, TaskState.CARRYING);
    Act place = awaitAct(ArmAction.PLACE);
    assertEquals(HANDLING.place(), place.target());
    assertEquals(TaskState.CARRYING, task(stage.fleet.snapshots().latest(), task).state());
    endAct();
    untilState(task, TaskState.DONE);
    assertEquals(List.of(), history("task.weighed"), "it weighs what was ordered");
  }

  @Test
  void anotherWeightThanOrderedIsTold() throws Exception {
    long task = submitForArm();
    awaitAct(ArmAction.PICK);
    scriptedRobot("r1").endAct(null, 1.4);
    untilState(task, TaskState.CARRYING);
    untilHistory("task.weighed", "r1 weighed the load: 1.4 kg, and 1 kg were ordered");
  }

  @Test
  void failedActAsksAndIsTriedAgain() throws Exception {
    long task = submitForArm();
    Act first = awaitAct(ArmAction.PICK);
    scriptedRobot("r1").endAct(NOTHING, null);
    Question question = awaitQuestion(task);
    assertEquals(Question.Kind.NOT_HANDLED, question.kind());
    assertEquals(List.of("try again", "done by hand", "cancel"), question.answers());
    assertTrue(
        question.question().english().startsWith("r1 found nothing to grasp, at "),
        question.question()::english);
    assertNull(scriptedRobot("r1").act(), "it waits for an answer");
    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.AGAIN)));
    Act again = awaitAct(ArmAction.PICK);
    assertTrue(again.seq() > first.seq());
    endAct();
    untilState(task, TaskState.CARRYING);
  }

  @Test
  void whatIsDoneByHandGoesOn() throws Exception {
    long task = submitForArm();
    awaitAct(ArmAction.PICK);
    endAct();
    awaitAct(ArmAction.PLACE);
    scriptedRobot("r1").endAct(new ActFailure("ELBOW_HOT", "The elbow is hot."), null);
    Question question = awaitQuestion(task);
    assertTrue(
        question.question().english().startsWith("r1 reports of its arm: The elbow is hot."),
        question.question()::english);
    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.BY_HAND)));
    untilState(task, TaskState.DONE);
  }

  @Test
  void cancelledBeforeThePickUpTheRobotIsFree() throws Exception {
    long task = submitForArm();
    awaitAct(ArmAction.PICK);
    scriptedRobot("r1").endAct(NOTHING, null);
    awaitQuestion(task);
    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.CANCEL)));
    untilState(task, TaskState.CANCELLED);
    assertNull(task(stage.fleet.snapshots().latest(), task).loadAt(), "it lies where it lay");
    until(view -> robot(view, "r1").work().task() == null);
  }

  @Test
  void serverThatIsStartedAnewInTheMidstOfAnActWaitsForItsEnd() throws Exception {
    long task = submitForArm();
    Act pick = awaitAct(ArmAction.PICK);
    stage.restart();
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    stage.pass(java.time.Duration.ofSeconds(5));
    assertEquals(pick, scriptedRobot("r1").act(), "it is not told anew");
    endAct();
    untilState(task, TaskState.CARRYING);
    awaitAct(ArmAction.PLACE);
    scriptedRobot("r1").loseConnection();
    stage.pass(java.time.Duration.ofSeconds(1));
    endAct();
    stage.restart();
    scriptedRobot("r1").speakAgain();
    untilState(task, TaskState.DONE);
    until(_ -> !scriptedRobot("r1").hasUnacknowledgedAct());
    assertEquals(1, history("task.at-object").size());
    assertEquals(1, history("task.delivered").size());
  }

  @Test
  void questionOutlastsTheServer() throws Exception {
    long task = submitForArm();
    awaitAct(ArmAction.PICK);
    scriptedRobot("r1").endAct(NOTHING, null);
    Question question = awaitQuestion(task);
    stage.restart();
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    assertEquals(question, awaitQuestion(task));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.AGAIN)));
    awaitAct(ArmAction.PICK);
  }

  @Test
  void robotWhoseDaemonWasStartedAnewIsToldTheActAgain() throws Exception {
    long task = submitForArm();
    Act first = awaitAct(ArmAction.PICK);
    scriptedRobot("r1").forgetAct();
    until(_ -> scriptedRobot("r1").act() != null);
    assertTrue(awaitAct(ArmAction.PICK).seq() > first.seq());
    endAct();
    untilState(task, TaskState.CARRYING);
  }

  @Test
  void placeOutOfReachIsRefusedWhenItIsOrdered() throws Exception {
    Answer<TaskView> far =
        answer(
            stage.fleet.submit(
                order(1, new ArmHandling(new Vec2(2, 2.5), HANDLING.place())), "Clara"));
    assertEquals(
        "arm.pick: An arm of a robot that stands at West cannot reach (2.00, 2.50): it is 1.5 m from"
            + " the shoulder, and the arm reaches 0.8 m. Enter a place that it reaches.",
        said(far));
    assertEquals(
        "load: No arm on this floor lifts 2.5 kg; the strongest lifts 2 kg. Split the load, or"
            + " order the task without an arm.",
        said(answer(stage.fleet.submit(order(2.5, HANDLING), "Clara"))));
    assertEquals(
        said(far),
        said(
            answer(
                stage.fleet.preview(
                    order(1, new ArmHandling(new Vec2(2, 2.5), HANDLING.place())), "Clara"))));
  }

  private static String said(Answer<?> answer) {
    Answer.Rejected<?> rejected = assertInstanceOf(Answer.Rejected.class, answer);
    return rejected.field() + ": " + rejected.sentence().english();
  }

  /** r2 is nearer, and has no arm. */
  @Test
  void robotWithoutAnArmIsNotGivenTheTask() throws Exception {
    TaskOrder back =
        new TaskOrder(
            "box",
            1,
            new Where.Station("East"),
            new Where.Station("West"),
            null,
            0,
            null,
            null,
            List.of(),
            List.of(),
            new ArmHandling(HANDLING.place(), HANDLING.pick()));
    assertEquals(List.of("r1"), accepted(stage.fleet.preview(back, "Clara")).chosen());
    long task = submit(back);
    until(view -> !task(view, task).robots().isEmpty());
    assertEquals(List.of("r1"), task(stage.fleet.snapshots().latest(), task).robots());
  }

  @Test
  void taskWithoutAnArmIsCarriedAsBefore() throws Exception {
    long task = submit(order(1, null));
    untilState(task, TaskState.DONE);
    assertNull(scriptedRobot("r1").act());
  }
}
