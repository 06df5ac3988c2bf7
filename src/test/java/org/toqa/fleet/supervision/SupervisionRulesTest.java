package org.toqa.fleet.supervision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.RobotView.Readings;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.supervision.Supervision.State;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.CameraView;
import org.toqa.link.message.AgentMessage.SeenBox;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.Question;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

class SupervisionRulesTest {
  private static final Vec2 PLACE = new Vec2(2, 2);
  private static final Vec2 ELSEWHERE = new Vec2(4, 2);
  private static final Vec2 TARGET = new Vec2(8, 2);
  private static final Instant NOON = Instant.parse("2026-01-01T12:00:00Z");

  private final SupervisionRules rules = new SupervisionRules(5);

  private static Supervision begun(boolean overlaps, SupervisedBox... boxes) {
    return new Supervision(
            "hall",
            "run",
            "r3",
            List.of("r1", "r2"),
            overlaps,
            "Clara",
            State.RUNNING,
            NOON,
            null,
            0,
            Map.of(),
            "")
        .withBoxes(List.of(boxes));
  }

  private static SupervisedBox unseen() {
    return SupervisedBox.unseen(1, TARGET);
  }

  private static SupervisedBox ordered() {
    return unseen().seenAt(PLACE).orderedAs(7);
  }

  private static RobotView robot(String name, RobotState state, @Nullable CameraView camera) {
    RobotView robot = Hall.robot(name, state, new Pose(1, 1, 0), "127.0.0.1", 7275);
    return robot.withTelemetry(
        new RobotView.Telemetry(
            robot.telemetry().pose(),
            robot.telemetry().battery(),
            new Readings(null, null, List.of(), null, null, null, camera),
            List.of(),
            NOON));
  }

  private static FleetSnapshot picture(
      RobotState supervisor, List<SeenBox> inView, @Nullable TaskView task) {
    return new FleetSnapshot(
        1,
        NOON,
        List.of(
            robot("r1", RobotState.IDLE, null),
            robot("r2", RobotState.IDLE, null),
            robot("r3", supervisor, new CameraView(4, inView))),
        task == null ? List.of() : List.of(task),
        0,
        List.of(),
        null,
        Map.of(),
        Map.of(),
        List.of());
  }

  private static TaskView task(TaskState state, @Nullable Question needs) {
    TaskPlace place = new TaskPlace(PLACE, null);
    TransportTask task =
        new TransportTask(7, "Box 1", 5, place, place, "hall", 0, null, null, "Clara", NOON)
            .withArm(new ArmHandling(PLACE, TARGET));
    return Views.task(task, state, false, List.of("r1"), null, null, false, needs, null, NOON);
  }

  private static Question question(Question.Kind kind, Sentence why) {
    return new Question(kind, why, List.of("cancel"), "r1", why, null);
  }

  private SupervisionRules.Step look(Supervision before, FleetSnapshot picture) {
    return rules.step(before, picture, 1, _ -> Optional.empty());
  }

  private static SupervisedBox box(SupervisionRules.Step step) {
    return Objects.requireNonNull(step.next().boxes().get(1));
  }

  @Test
  void whatTheSupervisorSeesIsOrdered() {
    List<SeenBox> inView = List.of(new SeenBox(1, PLACE), new SeenBox(99, ELSEWHERE));
    SupervisionRules.Step step =
        look(begun(true, unseen()), picture(RobotState.DRIVING, inView, null));
    assertEquals(PLACE, box(step).place());
    assertEquals(List.of(box(step)), step.toOrder());
    assertEquals(2, step.next().idleSeconds(), "both workers, for a second");
  }

  @Test
  void supervisorThatIsLostIsNotBelievedAndWhatItFoundIsCarriedOn() {
    List<SeenBox> inView = List.of(new SeenBox(1, PLACE));
    SupervisionRules.Step before =
        look(begun(true, unseen()), picture(RobotState.LOST, inView, null));
    assertNull(box(before).place());
    SupervisionRules.Step after =
        look(
            begun(true, ordered()),
            picture(RobotState.LOST, inView, task(TaskState.CARRYING, null)));
    assertEquals(7, box(after).task());
    assertFalse(after.isMissing());
  }

  @Test
  void workerThatIsLostWithTheBoxInItsArmLeavesItToAPerson() {
    TaskView asking =
        task(TaskState.CARRYING, question(Question.Kind.ON_BOARD, Phrase.IS_NOT_HEARD_OF.with()));
    SupervisionRules.Step step =
        look(begun(true, ordered()), picture(RobotState.IDLE, List.of(), asking));
    assertEquals(7, box(step).task(), "it is ordered nothing else");
    assertEquals(List.of(), step.toGiveBack());
    assertEquals(List.of(), step.toOrder());
    assertFalse(step.isMissing());
  }

  @Test
  void boxWhoseTaskAPersonHasCancelledIsLookedForAnew() {
    SupervisionRules.Step cancelled =
        look(
            begun(true, ordered()),
            picture(RobotState.IDLE, List.of(), task(TaskState.CANCELLED, null)));
    assertTrue(cancelled.isMissing());
    assertNull(box(cancelled).place());
    SupervisionRules.Step found =
        look(cancelled.next(), picture(RobotState.IDLE, List.of(new SeenBox(1, ELSEWHERE)), null));
    assertEquals(ELSEWHERE, box(found).place());
    assertEquals(1, found.toOrder().getFirst().tries(), "with another key");
  }

  @Test
  void boxThatIsTooHeavyIsGivenBackAndOrderedForTwo() {
    TaskView tooHeavy =
        task(
            TaskState.TO_OBJECT,
            question(Question.Kind.NOT_HANDLED, Phrase.ARM_TOO_WEAK.with(8.0)));
    SupervisionRules.Step weighed =
        look(begun(true, ordered()), picture(RobotState.IDLE, List.of(), tooHeavy));
    assertEquals(8, box(weighed).weight());
    assertEquals(List.of(7L), weighed.toGiveBack());
    assertEquals(List.of(), weighed.toOrder(), "it has its task still");
    SupervisionRules.Step givenBack =
        look(weighed.next(), picture(RobotState.IDLE, List.of(), task(TaskState.CANCELLED, null)));
    assertFalse(givenBack.isMissing());
    assertTrue(rules.isForTwo(givenBack.toOrder().getFirst()));
    assertEquals(PLACE, box(givenBack).place());
  }

  @Test
  void anotherFailureOfTheArmIsLeftToAPerson() {
    TaskView failed =
        task(
            TaskState.TO_OBJECT,
            question(Question.Kind.NOT_HANDLED, Phrase.ARM_GRASPED_NOTHING.with()));
    SupervisionRules.Step step =
        look(begun(true, ordered()), picture(RobotState.IDLE, List.of(), failed));
    assertEquals(List.of(), step.toGiveBack());
    assertEquals(7, box(step).task());
  }

  @Test
  void withoutOverlapNothingIsOrderedWhileABoxIsCarried() {
    SupervisedBox second = SupervisedBox.unseen(2, TARGET).seenAt(ELSEWHERE);
    FleetSnapshot carrying = picture(RobotState.IDLE, List.of(), task(TaskState.CARRYING, null));
    assertEquals(List.of(second), look(begun(true, ordered(), second), carrying).toOrder());
    assertEquals(List.of(), look(begun(false, ordered(), second), carrying).toOrder());
  }

  @Test
  void deliveredBoxIsDoneAndStaysSo() {
    SupervisionRules.Step done =
        look(
            begun(true, ordered()),
            picture(RobotState.IDLE, List.of(), task(TaskState.RETURNING, null)));
    assertTrue(box(done).delivered());
    assertTrue(done.next().isAllDelivered());
    SupervisionRules.Step later =
        look(done.next(), picture(RobotState.IDLE, List.of(new SeenBox(1, ELSEWHERE)), null));
    assertTrue(box(later).delivered());
    assertEquals(List.of(), later.toOrder());
  }

  @Test
  void boxThatIsSeenAtItsTargetIsDone() {
    SupervisionRules.Step step =
        look(
            begun(true, unseen()), picture(RobotState.IDLE, List.of(new SeenBox(1, TARGET)), null));
    assertTrue(box(step).delivered());
  }
}
