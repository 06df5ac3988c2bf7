package org.toqa.mission;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import net.jqwik.api.Example;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

class MissionTest {

  private static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");

  static final TransportTask TASK =
      new TransportTask(
          7,
          "box",
          3,
          new TaskPlace(new Vec2(1, 1), "Store"),
          new TaskPlace(new Vec2(5, 2), null),
          "lab",
          0,
          null,
          null,
          "ann",
          Instant.EPOCH);

  /** Along four stops: with a person at the first and third one, and half a minute at the last. */
  static final TransportTask TOUR =
      TASK.withStops(
          List.of(
              new Stop(TASK.start(), true, null),
              Stop.at(new TaskPlace(new Vec2(2, 1), "Mill")),
              new Stop(new TaskPlace(new Vec2(3, 1), "Oven"), true, null),
              new Stop(TASK.goal(), false, Duration.ofSeconds(30))));

  /** Along three stops without a load: with a person at the second one, 30 s at the last. */
  static final TransportTask DRIVE =
      new TransportTask(
              8, "tour", 0, place("Mill"), TASK.goal(), "lab", 0, null, null, "ann", Instant.EPOCH)
          .withStops(
              List.of(
                  Stop.at(place("Mill")),
                  new Stop(place("Oven"), true, null),
                  new Stop(TASK.goal(), false, Duration.ofSeconds(30))));

  /** The same, and it charges at the second and at the last one. */
  static final TransportTask CHARGING_DRIVE =
      DRIVE.withStops(
          List.of(
              Stop.at(place("Mill")),
              new Stop(place("Oven"), false, null, new Stop.Charge("C1", 0.8)),
              new Stop(TASK.goal(), true, Duration.ofSeconds(30), new Stop.Charge(null, null))));

  private static TaskPlace place(String station) {
    return new TaskPlace(new Vec2(station.length(), 1), station);
  }

  private static final TaskPlace THERE = new TaskPlace(new Vec2(3, 1.5), null);

  @Example
  void aDriveGoesFromStopToStopAndCarriesNothing() {
    Mission mission =
        Mission.queued(DRIVE).assign(List.of("r1"), Sentence.verbatim("near")).mission();
    assertEquals("Mill", mission.object().station());
    Mission.Step step = mission.apply(new MissionEvent.DriveStarted("r1", Phase.TO_OBJECT));
    assertEquals(List.of("r1 set out for Mill"), said(step));

    step = step.mission().apply(arrived(Phase.TO_OBJECT, 0));
    assertEquals(List.of("Leaves Mill, stop 1 of 3"), said(step));
    assertEquals(List.of(new MissionCommand.Drive("r1", Phase.TO_OBJECT)), step.commands());
    assertEquals("Oven", step.mission().object().station());
    assertFalse(step.mission().apply(arrived(Phase.TO_OBJECT, 0)).hasChanges(), "told twice");

    step = step.mission().apply(arrived(Phase.TO_OBJECT, 1));
    assertEquals(List.of("Waits at Oven"), said(step));
    assertEquals(List.of(), step.commands());
    step = step.mission().apply(new MissionEvent.GoOn("max", 1));
    assertEquals(
        List.of("max let the robot go on from Oven", "Leaves Oven, stop 2 of 3"), said(step));
    assertEquals(TaskState.TO_OBJECT, step.mission().state());

    step =
        step.mission()
            .apply(arrived(Phase.TO_OBJECT, 2))
            .mission()
            .apply(new MissionEvent.WaitEnded(2));
    assertEquals(TaskState.RETURNING, step.mission().state());
    assertEquals("The drive ended at (5.00, 2.00)", said(step).getLast());
    assertEquals(List.of(new MissionCommand.Drive("r1", Phase.HOME)), step.commands());
    assertTrue(step.mission().objectionTo(new MissionEvent.Cancel("max", null)).isPresent());
  }

  @Example
  void whoChargesGoesOnWhenItHasWhatWasOrdered() {
    Mission mission =
        Mission.queued(CHARGING_DRIVE).assign(List.of("r1"), Sentence.verbatim("near")).mission();
    assertTrue(mission.chargingStop().isEmpty());
    mission = mission.apply(arrived(Phase.TO_OBJECT, 0)).mission();
    assertEquals("charger C1", mission.chargingStop().orElseThrow().sentence().english());
    assertFalse(mission.isExchangeable(), "it has its turn");
    assertFalse(mission.apply(new MissionEvent.ChargeEnded(1, 0.8)).hasChanges(), "not there yet");

    Mission.Step step = mission.apply(arrived(Phase.TO_OBJECT, 1));
    assertEquals(List.of("Charges at charger C1"), said(step));
    assertFalse(step.mission().isWaitOver(Duration.ofSeconds(1_000_000)), "no time was said");
    step = step.mission().apply(new MissionEvent.ChargeEnded(1, 0.804));
    assertEquals(
        List.of("Charged to 80 % at charger C1", "Leaves charger C1, stop 2 of 3"), said(step));
    assertFalse(
        step.mission().apply(new MissionEvent.ChargeEnded(1, 0.9)).hasChanges(), "told twice");

    step = step.mission().apply(arrived(Phase.TO_OBJECT, 2));
    assertEquals(List.of("Charges at a charger of its choice"), said(step));
    assertTrue(step.mission().isWaitOver(Duration.ofSeconds(30)));
    step = step.mission().apply(new MissionEvent.WaitEnded(2));
    assertEquals("The drive ended at a charger of its choice", said(step).getLast());
    assertTrue(step.mission().chargingStop().isEmpty());
  }

  @Example
  void howFarARobotChargesIsSaidOrUsualWhereNothingElseIsWaitedFor() {
    TaskPlace place = TASK.goal();
    Duration minute = Duration.ofMinutes(1);
    assertEquals(Optional.of(0.8), charging(false, null, 0.8).chargesUntil(0.95));
    assertEquals(Optional.of(0.95), charging(false, null, null).chargesUntil(0.95));
    assertEquals(Optional.empty(), charging(false, minute, null).chargesUntil(0.95));
    assertEquals(Optional.empty(), charging(true, null, null).chargesUntil(0.95));
    assertEquals(Optional.empty(), new Stop(place, true, minute).chargesUntil(0.95));
  }

  private static Stop charging(boolean person, @Nullable Duration time, @Nullable Double until) {
    return new Stop(TASK.goal(), person, time, new Stop.Charge(null, until));
  }

  @Example
  void aDriveWhoseRobotFailsIsTakenOverAtTheStopThatWasNotLeft() {
    Mission waiting =
        Mission.queued(DRIVE)
            .assign(List.of("r1"), Sentence.verbatim("near"))
            .mission()
            .apply(arrived(Phase.TO_OBJECT, 0))
            .mission()
            .apply(arrived(Phase.TO_OBJECT, 1))
            .mission();
    Mission.Step step =
        waiting.apply(
            new MissionEvent.RobotFailed("r1", Sentence.verbatim("reports an error"), THERE));

    assertEquals(TaskState.QUEUED, step.mission().state());
    assertEquals("Waiting for a robot that drives to Oven", said(step).getLast());
    assertTrue(step.mission().waitingStop().isEmpty(), "the wait begins anew");
    Mission other = step.mission().assign(List.of("r2"), Sentence.verbatim("near")).mission();
    assertEquals("Oven", other.object().station());
    assertEquals(
        TaskState.CANCELLED,
        other.apply(new MissionEvent.Cancel("max", null)).mission().state(),
        "there is no load");
  }

  @Example
  void aTourGoesFromStopToStopAndWaitsWhereItShall() {
    Mission mission =
        Mission.queued(TOUR).assign(List.of("r1"), Sentence.verbatim("near")).mission();
    Mission.Step step = mission.apply(arrived(Phase.TO_OBJECT, 0));
    assertEquals(List.of("Waits at Store"), said(step));
    assertEquals(TaskState.TO_OBJECT, step.mission().state());
    assertEquals(List.of(), step.commands());
    assertFalse(step.mission().isWaitOver(Duration.ofSeconds(1_000_000)), "a person says it");

    step = step.mission().apply(new MissionEvent.GoOn("max", 0));
    assertEquals(List.of("max let the robot go on from Store", "Picked up at Store"), said(step));
    assertEquals(List.of(new MissionCommand.Drive("r1", Phase.TO_GOAL)), step.commands());
    assertEquals("Mill", step.mission().destination().station());

    step = step.mission().apply(arrived(Phase.TO_GOAL, 1));
    assertEquals(List.of("Leaves Mill, stop 2 of 4"), said(step));
    assertEquals("Oven", step.mission().destination().station());
    assertFalse(step.mission().apply(arrived(Phase.TO_GOAL, 1)).hasChanges(), "told twice");

    step = step.mission().apply(arrived(Phase.TO_GOAL, 2));
    assertEquals(List.of("Waits at Oven"), said(step));
    Mission held = step.mission().apply(new MissionEvent.Hold("max")).mission();
    assertTrue(held.objectionTo(new MissionEvent.GoOn("max", null)).isPresent());
    assertTrue(step.mission().objectionTo(new MissionEvent.GoOn("max", 0)).isPresent());
    step = step.mission().apply(new MissionEvent.GoOn("max", null));
    assertEquals(TaskState.CARRYING, step.mission().state());

    Mission waiting = step.mission().apply(arrived(Phase.TO_GOAL, 3)).mission();
    assertFalse(waiting.isWaitOver(Duration.ofSeconds(29)));
    assertTrue(waiting.isWaitOver(Duration.ofSeconds(30)));
    assertEquals(
        Duration.ofSeconds(20), waiting.progress().waited(NOON.plusSeconds(1), 20), "fleet's time");
    assertEquals(
        Duration.ZERO, waiting.progress().waited(NOON.minusSeconds(7200), 1), "it was set back");
    step = waiting.apply(new MissionEvent.WaitEnded(3));
    assertEquals(TaskState.RETURNING, step.mission().state());
    assertEquals(List.of(new MissionCommand.Drive("r1", Phase.HOME)), step.commands());
  }

  @Example
  void whatAnotherRobotFetchesOnTheWayGoesToTheStopThatWasNotLeft() {
    Mission mission =
        Mission.queued(TOUR)
            .assign(List.of("r1"), Sentence.verbatim("near"))
            .mission()
            .apply(arrived(Phase.TO_OBJECT, 0))
            .mission()
            .apply(new MissionEvent.GoOn("max", null))
            .mission()
            .apply(arrived(Phase.TO_GOAL, 1))
            .mission()
            .apply(new MissionEvent.RobotFailed("r1", Sentence.verbatim("reports an error"), THERE))
            .mission()
            .apply(new MissionEvent.Answer("max", Reply.ANOTHER))
            .mission();
    assertEquals(TaskState.QUEUED, mission.state());
    assertEquals(THERE, mission.object());

    mission =
        mission
            .assign(List.of("r2"), Sentence.verbatim("near"))
            .mission()
            .apply(new MissionEvent.PhaseEnded("r2", Phase.TO_OBJECT))
            .mission();

    assertEquals(TaskState.CARRYING, mission.state(), "nobody waits where it was set down");
    assertEquals("Oven", mission.destination().station());
  }

  private static MissionEvent.PhaseEnded arrived(Phase phase, int stop) {
    return new MissionEvent.PhaseEnded("r1", phase, stop, NOON);
  }

  @Example
  void oneRobotFetchesCarriesAndParks() {
    Mission.Step step = Mission.queued(TASK).assign(List.of("r1"), Sentence.verbatim("nearest"));
    assertEquals(TaskState.ASSIGNED, step.mission().state());
    assertEquals(List.of(new MissionCommand.Drive("r1", Phase.TO_OBJECT)), step.commands());

    step = step.mission().apply(new MissionEvent.DriveStarted("r1", Phase.TO_OBJECT));
    assertEquals(TaskState.TO_OBJECT, step.mission().state());

    step = step.mission().apply(new MissionEvent.PhaseEnded("r1", Phase.TO_OBJECT));
    assertEquals(TaskState.CARRYING, step.mission().state());
    assertEquals(List.of(new MissionCommand.Drive("r1", Phase.TO_GOAL)), step.commands());
    assertEquals(List.of("Picked up at Store"), said(step));

    step = step.mission().apply(new MissionEvent.PhaseEnded("r1", Phase.TO_GOAL));
    assertEquals(TaskState.RETURNING, step.mission().state());
    assertEquals(List.of("Delivered at (5.00, 2.00)"), said(step));

    step = step.mission().apply(new MissionEvent.PhaseEnded("r1", Phase.HOME));
    assertEquals(TaskState.DONE, step.mission().state());
    assertEquals(List.of(new MissionCommand.Unassign("r1")), step.commands());
  }

  @Example
  void phaseTwoStartsWhenAllRobotsAreAtTheObject() {
    Mission mission =
        Mission.queued(TASK).assign(List.of("r1", "r2"), Sentence.verbatim("heavy")).mission();
    Mission.Step first = mission.apply(new MissionEvent.PhaseEnded("r1", Phase.TO_OBJECT));
    assertEquals(TaskState.TO_OBJECT, first.mission().state());
    assertTrue(first.commands().isEmpty());

    Mission.Step second = first.mission().apply(new MissionEvent.PhaseEnded("r2", Phase.TO_OBJECT));
    assertEquals(TaskState.CARRYING, second.mission().state());
    assertEquals(
        List.of(
            new MissionCommand.Drive("r1", Phase.TO_GOAL),
            new MissionCommand.Drive("r2", Phase.TO_GOAL)),
        second.commands());
  }

  @Example
  void robotInPhaseThreeMayTakeTheNextTask() {
    Mission mission =
        Mission.queued(TASK).assign(List.of("r1"), Sentence.verbatim("nearest")).mission();
    mission = mission.apply(new MissionEvent.PhaseEnded("r1", Phase.TO_OBJECT)).mission();
    assertFalse(mission.apply(new MissionEvent.Retasked("r1")).hasChanges());
    mission = mission.apply(new MissionEvent.PhaseEnded("r1", Phase.TO_GOAL)).mission();
    assertEquals(TaskState.DONE, mission.apply(new MissionEvent.Retasked("r1")).mission().state());
  }

  @Example
  void beforeThePickUpAnotherRobotMayTakeItOver() {
    MissionEvent exchanged =
        new MissionEvent.Exchanged("r1", "r2", Sentence.verbatim("it is nearer"));

    Mission.Step step = toObject("r1").apply(exchanged);

    assertEquals(TaskState.ASSIGNED, step.mission().state());
    assertEquals(List.of("r2"), step.mission().robots());
    assertEquals(
        List.of(new MissionCommand.Unassign("r1"), new MissionCommand.Drive("r2", Phase.TO_OBJECT)),
        step.commands());
    assertEquals(List.of("Reassigned to r2 from r1: it is nearer"), said(step));
    assertFalse(step.mission().apply(exchanged).hasChanges(), "repeated");
    assertFalse(carrying("r1").apply(exchanged).hasChanges(), "with the load on board");
    assertFalse(
        toObject("r1").apply(new MissionEvent.Hold("max")).mission().apply(exchanged).hasChanges(),
        "held");
  }

  @Example
  void aRobotThatMustChargeGivesItsTaskBackButNeverALoadOnBoard() {
    MissionEvent charges =
        new MissionEvent.ChargingRequired("r1", Sentence.verbatim("its battery has 5 %"));

    assertEquals(TaskState.QUEUED, toObject("r1").apply(charges).mission().state());
    assertFalse(carrying("r1").apply(charges).hasChanges());
    Mission returning =
        carrying("r1").apply(new MissionEvent.PhaseEnded("r1", Phase.TO_GOAL)).mission();
    assertEquals(TaskState.DONE, returning.apply(charges).mission().state());
  }

  @Example
  void aRobotThatFailsBeforeItHasTheLoadGivesTheTaskBack() {
    Mission mission = toObject("r1");

    Mission.Step step =
        mission.apply(
            new MissionEvent.RobotFailed("r1", Sentence.verbatim("reports an error"), THERE));

    assertEquals(TaskState.QUEUED, step.mission().state());
    assertEquals(List.of(), step.mission().robots());
    assertEquals(TASK.start(), step.mission().object());
    assertEquals(List.of(new MissionCommand.Unassign("r1")), step.commands());
  }

  @Example
  void withTheLoadOnBoardAPersonIsAskedAndAnotherRobotFetchesItFromThere() {
    Mission asked =
        carrying("r1")
            .apply(new MissionEvent.RobotFailed("r1", Sentence.verbatim("reports an error"), THERE))
            .mission();
    assertEquals(TaskState.CARRYING, asked.state());
    assertEquals(
        List.of("another robot", "wait", "cancel"), asked.question().orElseThrow().answers());
    assertEquals(THERE, asked.loadAt());
    Question question = asked.question().orElseThrow();
    assertEquals(Question.Kind.ON_BOARD, question.kind());
    assertEquals(
        List.of("r1", Sentence.verbatim("reports an error"), THERE.text()),
        List.of(question.robot(), question.why(), question.place()));

    Mission queued = asked.apply(new MissionEvent.Answer("max", Reply.ANOTHER)).mission();

    assertEquals(TaskState.QUEUED, queued.state());
    assertEquals(THERE, queued.object());
    Mission again = queued.assign(List.of("r2"), Sentence.verbatim("free")).mission();
    again = again.apply(new MissionEvent.PhaseEnded("r2", Phase.TO_OBJECT)).mission();
    assertEquals(TaskState.CARRYING, again.state());
    assertEquals(null, again.loadAt());
  }

  @Example
  void theQuestionSaysWhetherTheLoadIsOnBoardAndWhetherItsPlaceIsKnown() {
    assertEquals(Question.Kind.NOT_FETCHED, kindWhenLost(toObject("r1"), THERE));
    assertEquals(Question.Kind.ON_BOARD, kindWhenLost(carrying("r1"), THERE));
    assertEquals(Question.Kind.ON_BOARD_SOMEWHERE, kindWhenLost(carrying("r1"), null));
  }

  private static Question.Kind kindWhenLost(Mission mission, @Nullable TaskPlace place) {
    return mission
        .apply(new MissionEvent.RobotLost("r1", place))
        .mission()
        .question()
        .orElseThrow()
        .kind();
  }

  @Example
  void whoSaidThatTheTaskWaitsIsNotAskedAgainUntilTheRobotWasBack() {
    MissionEvent failed =
        new MissionEvent.RobotFailed("r1", Sentence.verbatim("reports an error"), THERE);
    Mission waits =
        carrying("r1")
            .apply(failed)
            .mission()
            .apply(new MissionEvent.Answer("max", Reply.WAIT))
            .mission();

    assertFalse(waits.apply(failed).hasChanges());
    assertTrue(waits.question().isEmpty());
    Mission back = waits.apply(new MissionEvent.RobotRecovered("r1")).mission();
    assertTrue(back.apply(failed).mission().question().isPresent());
  }

  @Example
  void cancelWithTheLoadOnBoardNeedsAChoice() {
    Mission mission = carrying("r1");
    Objection objection = mission.objectionTo(new MissionEvent.Cancel("max", null)).orElseThrow();
    assertEquals(List.of("here", "back"), Objects.requireNonNull(objection.needs()).answers());
    assertFalse(mission.apply(new MissionEvent.Cancel("max", null)).hasChanges());

    Mission here = mission.apply(new MissionEvent.Cancel("max", LoadChoice.HERE)).mission();
    Mission set = here.apply(new MissionEvent.Stopped("r1", THERE)).mission();
    assertEquals(TaskState.CANCELLED, set.state());
    assertEquals(THERE, set.loadAt());

    Mission back = mission.apply(new MissionEvent.Cancel("max", LoadChoice.BACK)).mission();
    assertEquals(TASK.start(), back.destination());
    assertEquals(
        TaskState.CANCELLED,
        back.apply(new MissionEvent.PhaseEnded("r1", Phase.TO_GOAL)).mission().state());
  }

  @Example
  void withARobotThatCannotDriveTheLoadStaysOrAPersonAnswers() {
    Mission lost = carrying("r1").apply(new MissionEvent.RobotLost("r1", THERE)).mission();
    assertCancelledThere(lost);
    Mission awaited = lost.apply(new MissionEvent.Answer("max", Reply.WAIT)).mission();
    assertCancelledThere(awaited);
    for (LoadChoice choice : new LoadChoice[] {null, LoadChoice.BACK}) {
      MissionEvent.Cancel cancel = new MissionEvent.Cancel("max", choice);
      assertEquals(lost.question().orElseThrow(), lost.objectionTo(cancel).orElseThrow().needs());
      assertFalse(lost.apply(cancel).hasChanges());
    }

    Mission stopping =
        carrying("r1")
            .apply(new MissionEvent.Cancel("max", LoadChoice.HERE))
            .mission()
            .apply(new MissionEvent.RobotLost("r1", THERE))
            .mission();
    assertCancelledThere(stopping);
    assertEquals(
        TaskState.CANCELLED,
        stopping.apply(new MissionEvent.Cancel("max", null)).mission().state());
  }

  @Example
  void whereRobotsStillDriveTheyAreAwaitedAndNobodyElseIs() {
    MissionEvent.LoadState now = new MissionEvent.LoadState(THERE, Set.of("r1"));
    for (MissionEvent.OperatorCommand command :
        List.of(
            new MissionEvent.Cancel("max", LoadChoice.HERE),
            new MissionEvent.Answer("max", Reply.CANCEL))) {
      MissionEvent lost = new MissionEvent.RobotLost("r2", TASK.start());
      Mission carrying = carryingByTwo().apply(lost).mission();
      Mission stopping = carrying.apply(command.given(now)).mission();
      assertTrue(stopping.isStopping());
      assertFalse(stopping.apply(lost).hasChanges(), "r2 is needed no more");
      Mission set = stopping.apply(new MissionEvent.Stopped("r1", THERE)).mission();
      assertEquals(TaskState.CANCELLED, set.state());
      assertEquals(THERE, set.loadAt());

      MissionEvent.LoadState stands = new MissionEvent.LoadState(THERE, Set.of());
      Mission cancelled = carrying.apply(command.given(stands)).mission();
      assertEquals(TaskState.CANCELLED, cancelled.state());
      assertEquals(THERE, cancelled.loadAt(), "where it is now");
    }
  }

  private static Mission carryingByTwo() {
    Mission mission =
        Mission.queued(TASK).assign(List.of("r1", "r2"), Sentence.verbatim("heavy")).mission();
    for (String robot : mission.robots()) {
      mission = mission.apply(new MissionEvent.PhaseEnded(robot, Phase.TO_OBJECT)).mission();
    }
    return mission;
  }

  private static void assertCancelledThere(Mission mission) {
    Mission cancelled = mission.apply(new MissionEvent.Cancel("max", LoadChoice.HERE)).mission();
    assertEquals(TaskState.CANCELLED, cancelled.state());
    assertEquals(THERE, cancelled.loadAt());
  }

  @Example
  void whatIsDeliveredOrEndedIsNotCancelled() {
    Mission delivered =
        carrying("r1").apply(new MissionEvent.PhaseEnded("r1", Phase.TO_GOAL)).mission();
    MissionEvent.Cancel cancel = new MissionEvent.Cancel("max", LoadChoice.HERE);
    assertTrue(delivered.objectionTo(cancel).isPresent());
    assertTrue(
        delivered
            .apply(new MissionEvent.PhaseEnded("r1", Phase.HOME))
            .mission()
            .objectionTo(cancel)
            .isPresent());
  }

  private static List<String> said(Mission.Step step) {
    return step.history().stream().map(Sentence::english).toList();
  }

  private static Mission toObject(String robot) {
    return Mission.queued(TASK)
        .assign(List.of(robot), Sentence.verbatim("nearest"))
        .mission()
        .apply(new MissionEvent.DriveStarted(robot, Phase.TO_OBJECT))
        .mission();
  }

  private static Mission carrying(String robot) {
    return toObject(robot).apply(new MissionEvent.PhaseEnded(robot, Phase.TO_OBJECT)).mission();
  }
}
