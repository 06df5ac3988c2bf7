package org.toqa.mission;

import java.util.List;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** How a mission goes on while its robots do what they should. */
final class PhaseRules {
  private PhaseRules() {}

  static Mission.Step started(Mission mission, MissionEvent.DriveStarted event) {
    if (mission.state() != TaskState.ASSIGNED || event.phase() != 1) {
      return mission.unchanged();
    }
    return mission.in(TaskState.TO_OBJECT).step(List.of(), Phrase.SET_OUT.with(event.robot()));
  }

  static Mission.Step ended(Mission mission, MissionEvent.PhaseEnded event) {
    Carrier carrier = mission.carrier(event.robot()).orElseThrow();
    if (carrier.phase() != event.phase() || carrier.arrived() || mission.isStopping()) {
      return mission.unchanged();
    }
    Mission arrived = withoutTroubleOf(event.robot(), mission);
    arrived = arrived.replace(event.robot(), Carrier::arrivedAtEnd);
    return switch (event.phase()) {
      case 1 -> atObject(arrived, Phrase.IS_AT_LOAD.with(event.robot()));
      case 2 -> atDestination(arrived, event.robot());
      default -> arrived.letGo(event.robot(), Phrase.HAS_PARKED.with(event.robot()));
    };
  }

  static Mission.Step retasked(Mission mission, MissionEvent.Retasked event) {
    return mission.phaseOf(event.robot()) == 3
        ? mission.letGo(event.robot(), Phrase.TOOK_ANOTHER.with(event.robot()))
        : mission.unchanged();
  }

  static Mission.Step exchanged(Mission mission, MissionEvent.Exchanged event) {
    if (!mission.isExchangeable()) {
      return mission.unchanged();
    }
    return mission
        .by(List.of(Carrier.chosen(event.to())))
        .in(TaskState.ASSIGNED)
        .step(
            List.of(
                new MissionCommand.LetGo(event.robot()), new MissionCommand.Drive(event.to(), 1)),
            Phrase.GIVEN_INSTEAD.with(event.to(), event.robot(), event.why()));
  }

  static Mission.Step stopped(Mission mission, MissionEvent.Stopped event) {
    Carrier carrier = mission.carrier(event.robot()).orElseThrow();
    if (!mission.isStopping() || carrier.arrived()) {
      return mission.unchanged();
    }
    Mission stopped = mission.replace(event.robot(), Carrier::arrivedAtEnd);
    if (!isComplete(stopped)) {
      return stopped.step(List.of(), Phrase.HAS_STOPPED.with(event.robot()));
    }
    return stopped
        .withLoadAt(event.place())
        .letAllGo(
            TaskState.CANCELLED,
            Phrase.SET_DOWN.with(event.place().said()),
            Phrase.CANCELLED.with());
  }

  private static Mission.Step atObject(Mission mission, Sentence one) {
    if (!isComplete(mission)) {
      return mission.in(TaskState.TO_OBJECT).step(List.of(), one);
    }
    Mission carrying = mission.by(nextPhase(mission, 2)).in(TaskState.CARRYING);
    return carrying.step(
        carrying.driveAll(2),
        sentences(mission, one, Phrase.PICKED_UP.with(mission.object().said())));
  }

  private static Mission.Step atDestination(Mission mission, String robot) {
    Sentence where = mission.destination().said();
    if (mission.ending() == LoadChoice.BACK) {
      return isComplete(mission)
          ? mission
              .withLoadAt(null)
              .letAllGo(
                  TaskState.CANCELLED, Phrase.BROUGHT_BACK.with(where), Phrase.CANCELLED.with())
          : mission.step(List.of(), Phrase.IS_BACK_AT_START.with(robot));
    }
    Sentence one = Phrase.IS_AT_GOAL.with(robot);
    if (!isComplete(mission)) {
      return mission.step(List.of(), one);
    }
    Mission returning =
        mission.by(nextPhase(mission, 3)).in(TaskState.RETURNING).withLoadAt(null).troubled(null);
    return returning.step(
        returning.driveAll(3), sentences(mission, one, Phrase.DELIVERED.with(where)));
  }

  private static Mission withoutTroubleOf(String robot, Mission mission) {
    Trouble trouble = mission.trouble();
    return trouble != null && trouble.robot().equals(robot) ? mission.troubled(null) : mission;
  }

  private static boolean isComplete(Mission mission) {
    return mission.carriers().stream().allMatch(c -> c.arrived() || c.released());
  }

  private static List<Carrier> nextPhase(Mission mission, int phase) {
    return mission.carriers().stream().map(c -> c.released() ? c : c.inPhase(phase)).toList();
  }

  private static Sentence[] sentences(Mission mission, Sentence one, Sentence all) {
    return mission.carriers().size() == 1 ? new Sentence[] {all} : new Sentence[] {one, all};
  }
}
