package org.toqa.mission;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What becomes of a mission when one of its robots cannot go on: without the load it goes back to
 * the queue, with the load on board a person is asked, and after delivery the robot is let go.
 */
final class TroubleRules {
  private TroubleRules() {}

  static Mission.Step onRobotLost(Mission mission, MissionEvent.RobotLost event) {
    return mission.phaseOf(event.robot()) == Phase.HOME
        ? mission.unchangedStep()
        : ask(
            mission,
            new Trouble(event.robot(), Phrase.IS_NOT_HEARD_OF.with(), event.place(), false));
  }

  /** An operator's choice that the mission waits is valid until the robot is back. */
  static Mission.Step onRobotFailed(Mission mission, MissionEvent.RobotFailed event) {
    Trouble known = troubleOf(event.robot(), mission);
    if (known != null && known.isAwaited()) {
      return mission.unchangedStep();
    }
    return stopWorking(mission, new Trouble(event.robot(), event.why(), event.place(), false));
  }

  static Mission.Step onRobotWithdrawn(Mission mission, MissionEvent.RobotWithdrawn event) {
    return stopWorking(
        mission, new Trouble(event.robot(), Phrase.WAS_TAKEN_OUT.with(), event.place(), false));
  }

  /** No robot goes to charge with a load on board. */
  static Mission.Step onChargingRequired(Mission mission, MissionEvent.ChargingRequired event) {
    Sentence sentence = Phrase.MUST_CHARGE_SINCE.with(event.robot(), event.why());
    return switch (mission.phaseOf(event.robot())) {
      case TO_OBJECT ->
          requeue(
              mission,
              new Trouble(event.robot(), Phrase.MUST_CHARGE.with(), null, false),
              Phrase.ANOTHER_LOOKED_FOR.with(sentence));
      case TO_GOAL -> mission.unchangedStep();
      case HOME, NONE -> mission.unassign(event.robot(), sentence);
    };
  }

  static Mission.Step onRobotRecovered(Mission mission, MissionEvent.RobotRecovered event) {
    Trouble known = troubleOf(event.robot(), mission);
    return known == null || known.isOfArm()
        ? mission.unchangedStep()
        : mission.withTrouble(null).step(List.of(), Phrase.CAN_GO_ON.with(event.robot()));
  }

  /** The robot stands where its arm should have acted, until a person has answered. */
  static Mission.Step onActFailed(Mission mission, MissionEvent.ActFailed event) {
    return mission.phaseOf(event.robot()) == event.phase()
            && mission.armTask(event.robot()).isPresent()
        ? ask(mission, new Trouble(event.robot(), event.why(), event.place(), false, true))
        : mission.unchangedStep();
  }

  static Mission.Step answer(Mission mission, MissionEvent.Answer event) {
    Trouble known = mission.trouble();
    if (known == null) {
      return mission.unchangedStep();
    }
    Trouble trouble = known.withPlace(event.load().place());
    return switch (event.reply()) {
      case WAIT ->
          mission
              .withTrouble(trouble.withWaiting())
              .step(List.of(), Phrase.SAID_TO_WAIT.with(event.user(), trouble.robot()));
      case AGAIN ->
          mission
              .withTrouble(null)
              .step(List.of(), Phrase.SAID_TRY_AGAIN.with(event.user(), trouble.robot()));
      case BY_HAND -> endByHand(mission, trouble, event.user());
      case ANOTHER -> requeue(mission, trouble, Phrase.GAVE_TO_ANOTHER.with(event.user()));
      case CANCEL -> cancel(mission, event.user(), event.load());
    };
  }

  /** Whether one of its robots cannot drive, or nobody knows whether it does. */
  static boolean isStranded(Mission mission) {
    Trouble trouble = mission.trouble();
    return trouble != null && !trouble.isOfArm();
  }

  /**
   * Of a mission in trouble: where none of its robots drives, nobody needs to stop, and the load
   * stays where it is.
   */
  static Mission.Step cancel(Mission mission, String user, MissionEvent.LoadState load) {
    if (isCarrying(mission) && mission.robots().stream().anyMatch(load.driving()::contains)) {
      return mission.isStopping()
          ? mission.unchangedStep()
          : OperatorCommandRules.stopHere(mission.withTrouble(null), user, load.driving());
    }
    Trouble trouble = Objects.requireNonNull(mission.trouble()).withPlace(load.place());
    return mission
        .withLoadAt(isCarrying(mission) ? trouble.place() : mission.setDownPlace())
        .unassignAll(
            TaskState.CANCELLED,
            isCarrying(mission)
                ? Phrase.CANCELLED_LOAD_STAYS.with(user, placeSentence(trouble))
                : Phrase.CANCELLED_BY.with(user));
  }

  private static Mission.Step endByHand(Mission mission, Trouble trouble, String user) {
    Mission.Step step =
        PhaseRules.onPhaseEnded(
            mission,
            new MissionEvent.PhaseEnded(trouble.robot(), mission.phaseOf(trouble.robot())));
    return new Mission.Step(
        step.mission(),
        step.commands(),
        Stream.concat(
                Stream.of(Phrase.DONE_BY_HAND.with(user, trouble.robot())), step.history().stream())
            .toList());
  }

  static Optional<Question> question(Mission mission) {
    Trouble trouble = mission.trouble();
    if (trouble == null || trouble.isAwaited()) {
      return Optional.empty();
    }
    List<String> answers = answers(mission, trouble).map(Reply::word).toList();
    if (trouble.isOfArm()) {
      return Optional.of(
          Question.about(
              trouble,
              Question.Kind.NOT_HANDLED,
              (isCarrying(mission) ? Phrase.ASK_AFTER_PLACING : Phrase.ASK_AFTER_PICKING)
                  .with(trouble.sentence(), placeSentence(trouble)),
              answers));
    }
    if (!isCarrying(mission)) {
      return Optional.of(
          Question.about(
              trouble,
              Question.Kind.NOT_FETCHED,
              (mission.task().isDrive() ? Phrase.ASK_FOR_ANOTHER_TO_DRIVE : Phrase.ASK_FOR_ANOTHER)
                  .with(trouble.sentence()),
              answers));
    }
    Phrase question =
        answers.contains(Reply.ANOTHER.word())
            ? Phrase.ASK_FOR_ANOTHER_WITH_LOAD
            : Phrase.ASK_TO_WAIT_WITH_LOAD;
    return Optional.of(
        Question.about(
            trouble,
            trouble.place() == null ? Question.Kind.ON_BOARD_SOMEWHERE : Question.Kind.ON_BOARD,
            question.with(trouble.sentence(), placeSentence(trouble), trouble.robot()),
            answers));
  }

  private static Stream<Reply> answers(Mission mission, Trouble trouble) {
    if (trouble.isOfArm()) {
      return Stream.of(Reply.AGAIN, Reply.BY_HAND, Reply.CANCEL);
    }
    if (!isCarrying(mission)) {
      return Stream.of(Reply.ANOTHER, Reply.WAIT);
    }
    return trouble.place() == null || mission.isStopping()
        ? Stream.of(Reply.WAIT, Reply.CANCEL)
        : Stream.of(Reply.ANOTHER, Reply.WAIT, Reply.CANCEL);
  }

  private static Mission.Step stopWorking(Mission mission, Trouble trouble) {
    return switch (mission.phaseOf(trouble.robot())) {
      case TO_OBJECT ->
          requeue(mission, trouble, Phrase.ANOTHER_LOOKED_FOR.with(trouble.sentence()));
      case TO_GOAL -> ask(mission, trouble);
      case HOME, NONE -> mission.unassign(trouble.robot(), trouble.sentence());
    };
  }

  private static Mission.Step ask(Mission mission, Trouble trouble) {
    Trouble known = mission.trouble();
    if (known != null && known.isSameAs(trouble)) {
      return mission.unchangedStep();
    }
    if (mission.isStopping() && mission.phaseHasEnded(trouble.robot())) {
      return mission.unchangedStep(); // who has stopped is needed no more
    }
    if (known != null && !known.robot().equals(trouble.robot())) {
      return mission.unchangedStep(); // one question at a time; the next is asked after its answer
    }
    TaskPlace place = trouble.place() == null && known != null ? known.place() : trouble.place();
    Trouble asked = new Trouble(trouble.robot(), trouble.why(), place, false, trouble.isOfArm());
    Sentence sentence =
        isCarrying(mission)
            ? Phrase.WITH_LOAD.with(asked.sentence(), placeSentence(asked))
            : asked.sentence();
    return mission.withTrouble(asked).step(List.of(), sentence);
  }

  /** What was on board is where its robot was last. */
  private static Mission.Step requeue(Mission mission, Trouble trouble, Sentence sentence) {
    Mission queued =
        isCarrying(mission) && trouble.place() != null
            ? mission.withLoadAt(trouble.place())
            : mission;
    return queued.unassignAll(
        TaskState.QUEUED,
        sentence,
        (queued.task().isDrive() ? Phrase.DRIVE_WAITS_FOR_ROBOT : Phrase.WAITS_FOR_ROBOT)
            .with(queued.objectSentence()));
  }

  private static boolean isCarrying(Mission mission) {
    return mission.state() == TaskState.CARRYING;
  }

  private static @Nullable Trouble troubleOf(String robot, Mission mission) {
    Trouble trouble = mission.trouble();
    return trouble != null && trouble.robot().equals(robot) ? trouble : null;
  }

  private static Sentence placeSentence(Trouble trouble) {
    TaskPlace place = trouble.place();
    return place == null ? Phrase.NOWHERE_KNOWN.with() : Phrase.AT_PLACE.with(place.sentence());
  }
}
