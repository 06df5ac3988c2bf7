package org.toqa.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What people may want of a mission, and what follows. */
final class OperatorCommandRules {
  private OperatorCommandRules() {}

  static Optional<Objection> objection(Mission mission, MissionEvent.OperatorCommand command) {
    return switch (command) {
      case MissionEvent.Cancel cancel -> objectionToCancel(mission, cancel);
      case MissionEvent.Hold ignored -> objectionToChange(mission);
      case MissionEvent.Resume ignored -> objectionToChange(mission);
      case MissionEvent.Prioritise ignored -> objectionToChange(mission);
      case MissionEvent.Edit edit -> objectionToEdit(mission, edit);
      case MissionEvent.Answer answer -> objectionToAnswer(mission, answer);
      case MissionEvent.HandOver ignored -> objectionToChange(mission);
      case MissionEvent.GoOn goOn -> StopRules.objection(mission, goOn);
      case MissionEvent.MoveLoad ignored -> objectionWithoutLeftLoad(mission);
      case MissionEvent.RemoveLoad ignored -> objectionWithoutLeftLoad(mission);
    };
  }

  private static Optional<Objection> objectionWithoutLeftLoad(Mission mission) {
    return mission.leftLoad().isPresent()
        ? Optional.empty()
        : Optional.of(Objection.of(Phrase.NO_LOAD_LEFT.with(mission.id())));
  }

  private static Optional<Objection> objectionToCancel(
      Mission mission, MissionEvent.Cancel cancel) {
    return switch (mission.state()) {
      case CANCELLED -> Optional.empty();
      case DONE, FAILED -> objectionToChange(mission);
      case RETURNING ->
          Optional.of(
              Objection.of(
                  (mission.task().isDrive() ? Phrase.DRIVEN_ALREADY : Phrase.DELIVERED_ALREADY)
                      .with()));
      case CARRYING -> objectionToCancelOnBoard(mission, cancel);
      case QUEUED, ASSIGNED, TO_OBJECT -> Optional.empty();
    };
  }

  /** Who cannot drive carries nothing back, nor stops to be asked where it sets the load down. */
  private static Optional<Objection> objectionToCancelOnBoard(
      Mission mission, MissionEvent.Cancel cancel) {
    LoadChoice choice = choice(mission, cancel);
    if (choice == LoadChoice.HERE) {
      return Optional.empty();
    }
    Optional<Question> open = mission.question().filter(_ -> TroubleRules.isStranded(mission));
    if (open.isPresent()) {
      return open.map(question -> new Objection(question.question(), question));
    }
    return choice == null ? Optional.of(setDownObjection(mission)) : Optional.empty();
  }

  private static @Nullable LoadChoice choice(Mission mission, MissionEvent.Cancel cancel) {
    return cancel.choice() == null ? mission.ending() : cancel.choice();
  }

  private static Objection setDownObjection(Mission mission) {
    Sentence question = Phrase.ASK_WHERE_TO.with(mission.task().start().sentence());
    return new Objection(
        question,
        new Question(Question.Kind.SET_DOWN, question, List.of("here", "back"), null, null, null));
  }

  private static Optional<Objection> objectionToChange(Mission mission) {
    return mission.state().isEnded()
        ? Optional.of(Objection.of(Phrase.TASK_HAS_ENDED.with(mission.id())))
        : Optional.empty();
  }

  /** What was fetched once is no longer as it was ordered. */
  private static Optional<Objection> objectionToEdit(Mission mission, MissionEvent.Edit event) {
    if (mission.state() != TaskState.QUEUED || mission.setDownPlace() != null) {
      return Optional.of(Objection.of(Phrase.TASK_WAITS_NO_MORE.with(mission.id())));
    }
    OrderPart part = mission.task().part();
    return part != null
            && part.kind() == OrderPart.Kind.STOPS
            && !event.order().hasSameTransport(mission.task())
        ? Optional.of(Objection.of(Phrase.LEG_STAYS_AS_ORDERED.with(mission.id(), part.order())))
        : Optional.empty();
  }

  private static Optional<Objection> objectionToAnswer(
      Mission mission, MissionEvent.Answer answer) {
    Optional<Question> question = mission.question();
    if (question.isEmpty()) {
      return Optional.of(Objection.of(Phrase.TASK_ASKS_NOTHING.with(mission.id())));
    }
    return question.get().answers().contains(answer.reply().word())
        ? Optional.empty()
        : Optional.of(
            new Objection(
                Phrase.ANSWER_WITH_ONE_OF.with(String.join(", ", question.get().answers())),
                question.get()));
  }

  static Mission.Step cancel(Mission mission, MissionEvent.Cancel event) {
    if (mission.state().isEnded()) {
      return mission.unchangedStep();
    }
    if (mission.state() != TaskState.CARRYING) {
      return mission.unassignAll(TaskState.CANCELLED, Phrase.CANCELLED_BY.with(event.user()));
    }
    LoadChoice choice = choice(mission, event);
    if (choice == LoadChoice.HERE && TroubleRules.isStranded(mission)) {
      return TroubleRules.cancel(mission, event.user(), event.load());
    }
    if (choice == null || choice == mission.ending()) {
      return mission.unchangedStep();
    }
    Mission ending = withEnding(mission, choice);
    return switch (choice) {
      case HERE -> ending.step(stopCommands(ending), Phrase.CANCELLED_LOAD_HERE.with(event.user()));
      case BACK ->
          ending.step(
              ending.driveCommands(Phase.TO_GOAL),
              Phrase.CANCELLED_LOAD_BACK.with(event.user(), mission.task().start().sentence()));
    };
  }

  /**
   * Its robots stop and set the load down.
   *
   * @param driving those that have to be waited for; the others cannot drive, or are not heard
   */
  static Mission.Step stopHere(Mission mission, String user, Set<String> driving) {
    Mission ending = withEnding(mission, LoadChoice.HERE);
    Mission stopping =
        ending.withAssignedRobots(
            ending.assignedRobots().stream()
                .map(c -> driving.contains(c.robot()) ? c : c.withArrived())
                .toList());
    return stopping.step(stopCommands(stopping), Phrase.CANCELLED_LOAD_HERE.with(user));
  }

  private static Mission withEnding(Mission mission, LoadChoice choice) {
    return withRobotsDriving(mission)
        .withProgress(mission.progress().withoutWait())
        .withEnding(choice);
  }

  static Mission.Step hold(Mission mission, MissionEvent.Hold event) {
    return mission.held()
        ? mission.unchangedStep()
        : mission.withHeld(true).step(List.of(), Phrase.TASK_PUT_ON_HOLD.with(event.user()));
  }

  /** Of a leg that is not on hold: it begins without the one before it. */
  static Mission.Step resume(Mission mission, MissionEvent.Resume event) {
    if (mission.held()) {
      return mission.withHeld(false).step(List.of(), Phrase.TASK_LET_GO_ON.with(event.user()));
    }
    OrderPart part = mission.task().part();
    return part != null && part.awaitsPrevious() && !event.fromHoldOnly()
        ? mission
            .withPart(part.withAwaitsPrevious(false))
            .step(List.of(), Phrase.LEG_LET_BEGIN.with(event.user(), part.position() - 1))
        : mission.unchangedStep();
  }

  static Mission.Step prioritise(Mission mission, MissionEvent.Prioritise event) {
    int before = mission.task().priority();
    return before == event.priority()
        ? mission.unchangedStep()
        : mission
            .withPriority(event.priority())
            .step(List.of(), Phrase.PRIORITY_CHANGED.with(event.user(), before, event.priority()));
  }

  static Mission.Step edit(Mission mission, MissionEvent.Edit event) {
    TransportTask before = mission.task();
    Mission edited = mission.withOrder(event.order());
    return edited.equals(mission)
        ? mission.unchangedStep()
        : edited.step(
            List.of(),
            Phrase.TASK_EDITED.with(
                event.user(),
                Sentence.verbatim(before.name()),
                before.load(),
                before.start().sentence(),
                before.goal().sentence(),
                before.priority()));
  }

  static Mission.Step handOver(Mission mission, MissionEvent.HandOver event) {
    return Objects.equals(mission.task().owner(), event.newOwner())
        ? mission.unchangedStep()
        : mission
            .withOwner(event.newUser(), event.newOwner())
            .step(
                List.of(),
                Phrase.TASK_HANDED_OVER.with(event.user(), mission.task().user(), event.newUser()));
  }

  static Mission.Step moveLeftLoad(Mission mission, MissionEvent.MoveLoad event) {
    return mission.leftLoad().filter(place -> !place.equals(event.place())).isPresent()
        ? mission
            .withLoadAt(event.place())
            .step(List.of(), Phrase.LOAD_MOVED.with(event.user(), event.place().sentence()))
        : mission.unchangedStep();
  }

  static Mission.Step endLeftLoad(Mission mission, Sentence sentence) {
    return mission.leftLoad().isPresent()
        ? mission.withLoadAt(null).step(List.of(), sentence)
        : mission.unchangedStep();
  }

  /** Robots that had arrived somewhere drive anew. */
  private static Mission withRobotsDriving(Mission mission) {
    return mission.withAssignedRobots(
        mission.assignedRobots().stream()
            .map(c -> c.unassigned() ? c : c.withPhase(Phase.TO_GOAL))
            .toList());
  }

  private static List<MissionCommand> stopCommands(Mission mission) {
    List<MissionCommand> commands = new ArrayList<>();
    for (AssignedRobot c : mission.assignedRobots()) {
      if (!c.unassigned()) {
        commands.add(new MissionCommand.Stop(c.robot()));
      }
    }
    return commands;
  }
}
