package org.toqa.mission;

import java.util.List;
import java.util.Optional;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** How robots wait at a mission's stops, and drive on from them. */
final class StopRules {
  private StopRules() {}

  static Optional<Objection> objection(Mission mission, MissionEvent.GoOn event) {
    Integer seen = event.stop();
    if (mission.waitingStop().isEmpty() || (seen != null && seen != mission.progress().stop())) {
      return Optional.of(Objection.of(Phrase.WAITS_AT_NO_STOP.with(mission.id())));
    }
    return mission.held()
        ? Optional.of(Objection.of(Phrase.RESUME_FIRST.with(mission.id())))
        : Optional.empty();
  }

  static Mission.Step goOn(Mission mission, MissionEvent.GoOn event) {
    return leave(mission, Phrase.SAID_TO_GO_ON.with(event.user(), place(mission)));
  }

  static Mission.Step onWaitEnded(Mission mission, MissionEvent.WaitEnded event) {
    return mission.waitingStop().isEmpty() || mission.progress().stop() != event.stop()
        ? mission.unchangedStep()
        : leave(mission, Phrase.WAITED_LONG_ENOUGH.with(place(mission)));
  }

  static Mission.Step onChargeEnded(Mission mission, MissionEvent.ChargeEnded event) {
    return mission.waitingStop().filter(stop -> stop.charge() != null).isEmpty()
            || mission.progress().stop() != event.stop()
        ? mission.unchangedStep()
        : leave(
            mission, Phrase.CHARGED_ENOUGH.with(place(mission), Math.round(100 * event.battery())));
  }

  private static Sentence place(Mission mission) {
    return mission.waitingStop().orElseThrow().sentence();
  }

  private static Mission.Step leave(Mission mission, Sentence why) {
    Mission going = mission.withProgress(mission.progress().withoutWait());
    return mission.state() == TaskState.CARRYING
        ? PhaseRules.leaveStop(going, List.of(why))
        : PhaseRules.leaveObject(going, List.of(why));
  }
}
