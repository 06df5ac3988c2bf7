package org.toqa.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What people may want of a mission, and what follows. */
final class WishRules {
  private WishRules() {}

  static Optional<Objection> objection(Mission mission, MissionEvent.Wish wish) {
    return switch (wish) {
      case MissionEvent.Cancel cancel -> toCancelling(mission, cancel);
      case MissionEvent.Hold ignored -> toChanging(mission);
      case MissionEvent.Resume ignored -> toChanging(mission);
      case MissionEvent.Prioritise ignored -> toChanging(mission);
      case MissionEvent.Answer answer -> toAnswering(mission, answer);
    };
  }

  private static Optional<Objection> toCancelling(Mission mission, MissionEvent.Cancel cancel) {
    return switch (mission.state()) {
      case CANCELLED -> Optional.empty();
      case DONE, FAILED -> toChanging(mission);
      case RETURNING -> Optional.of(Objection.because(Phrase.DELIVERED_ALREADY.with()));
      case CARRYING ->
          cancel.choice() == null && mission.ending() == null
              ? Optional.of(whereTo(mission))
              : Optional.empty();
      case QUEUED, ASSIGNED, TO_OBJECT -> Optional.empty();
    };
  }

  private static Objection whereTo(Mission mission) {
    Sentence question = Phrase.ASK_WHERE_TO.with(mission.task().start().said());
    return new Objection(
        question,
        new Question(Question.Kind.SET_DOWN, question, List.of("here", "back"), null, null, null));
  }

  private static Optional<Objection> toChanging(Mission mission) {
    return mission.state().isEnded()
        ? Optional.of(Objection.because(Phrase.TASK_HAS_ENDED.with(mission.id())))
        : Optional.empty();
  }

  private static Optional<Objection> toAnswering(Mission mission, MissionEvent.Answer answer) {
    Optional<Question> question = mission.question();
    if (question.isEmpty()) {
      return Optional.of(Objection.because(Phrase.TASK_ASKS_NOTHING.with(mission.id())));
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
      return mission.unchanged();
    }
    if (mission.state() != TaskState.CARRYING) {
      return mission.letAllGo(TaskState.CANCELLED, Phrase.CANCELLED_BY.with(event.user()));
    }
    LoadChoice choice = event.choice();
    if (choice == null || choice == mission.ending()) {
      return mission.unchanged();
    }
    Mission ending = onTheWayAgain(mission).ending(choice);
    return switch (choice) {
      case HERE -> ending.step(stopAll(ending), Phrase.CANCELLED_LOAD_HERE.with(event.user()));
      case BACK ->
          ending.step(
              ending.driveAll(2),
              Phrase.CANCELLED_LOAD_BACK.with(event.user(), mission.task().start().said()));
    };
  }

  static Mission.Step hold(Mission mission, MissionEvent.Hold event) {
    return mission.held()
        ? mission.unchanged()
        : mission.onHold(true).step(List.of(), Phrase.TASK_PUT_ON_HOLD.with(event.user()));
  }

  static Mission.Step resume(Mission mission, MissionEvent.Resume event) {
    return mission.held()
        ? mission.onHold(false).step(List.of(), Phrase.TASK_LET_GO_ON.with(event.user()))
        : mission.unchanged();
  }

  static Mission.Step prioritise(Mission mission, MissionEvent.Prioritise event) {
    int before = mission.task().priority();
    return before == event.priority()
        ? mission.unchanged()
        : mission
            .prioritised(event.priority())
            .step(List.of(), Phrase.PRIORITY_CHANGED.with(event.user(), before, event.priority()));
  }

  /** Robots that had arrived somewhere drive anew. */
  private static Mission onTheWayAgain(Mission mission) {
    return mission.by(
        mission.carriers().stream().map(c -> c.released() ? c : c.inPhase(2)).toList());
  }

  private static List<MissionCommand> stopAll(Mission mission) {
    List<MissionCommand> commands = new ArrayList<>();
    for (Carrier c : mission.carriers()) {
      if (!c.released()) {
        commands.add(new MissionCommand.Stop(c.robot()));
      }
    }
    return commands;
  }
}
