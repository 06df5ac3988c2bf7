package org.toqa.mission;

import java.util.List;

/** How a mission goes on while its robots do what they should. */
final class PhaseRules {
  private PhaseRules() {}

  static Mission.Step started(Mission mission, MissionEvent.DriveStarted event) {
    if (mission.state() != TaskState.ASSIGNED || event.phase() != 1) {
      return mission.unchanged();
    }
    return mission.in(TaskState.TO_OBJECT).step(List.of(), event.robot() + " set out for the load");
  }

  static Mission.Step ended(Mission mission, MissionEvent.PhaseEnded event) {
    Carrier carrier = mission.carrier(event.robot()).orElseThrow();
    if (carrier.phase() != event.phase() || carrier.arrived() || mission.isStopping()) {
      return mission.unchanged();
    }
    Mission arrived = withoutTroubleOf(event.robot(), mission);
    arrived = arrived.replace(event.robot(), Carrier::arrivedAtEnd);
    return switch (event.phase()) {
      case 1 -> atObject(arrived, event.robot() + " is at the load");
      case 2 -> atDestination(arrived, event.robot());
      default -> arrived.letGo(event.robot(), event.robot() + " has parked");
    };
  }

  static Mission.Step retasked(Mission mission, MissionEvent.Retasked event) {
    return mission.phaseOf(event.robot()) == 3
        ? mission.letGo(event.robot(), event.robot() + " took another task on its way home")
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
            "Given to " + event.to() + " instead of " + event.robot() + ": " + event.why());
  }

  static Mission.Step stopped(Mission mission, MissionEvent.Stopped event) {
    Carrier carrier = mission.carrier(event.robot()).orElseThrow();
    if (!mission.isStopping() || carrier.arrived()) {
      return mission.unchanged();
    }
    Mission stopped = mission.replace(event.robot(), Carrier::arrivedAtEnd);
    if (!isComplete(stopped)) {
      return stopped.step(List.of(), event.robot() + " has stopped");
    }
    return stopped
        .withLoadAt(event.place())
        .letAllGo(TaskState.CANCELLED, "Set down at " + event.place().text(), "Cancelled");
  }

  private static Mission.Step atObject(Mission mission, String one) {
    if (!isComplete(mission)) {
      return mission.in(TaskState.TO_OBJECT).step(List.of(), one);
    }
    Mission carrying = mission.by(nextPhase(mission, 2)).in(TaskState.CARRYING);
    return carrying.step(
        carrying.driveAll(2), sentences(mission, one, "Picked up at " + mission.object().text()));
  }

  private static Mission.Step atDestination(Mission mission, String robot) {
    String where = mission.destination().text();
    if (mission.ending() == LoadChoice.BACK) {
      return isComplete(mission)
          ? mission
              .withLoadAt(null)
              .letAllGo(TaskState.CANCELLED, "Brought back to " + where, "Cancelled")
          : mission.step(List.of(), robot + " is back at the start");
    }
    String one = robot + " is at the goal";
    if (!isComplete(mission)) {
      return mission.step(List.of(), one);
    }
    Mission returning =
        mission.by(nextPhase(mission, 3)).in(TaskState.RETURNING).withLoadAt(null).troubled(null);
    return returning.step(returning.driveAll(3), sentences(mission, one, "Delivered at " + where));
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

  private static String[] sentences(Mission mission, String one, String all) {
    return mission.carriers().size() == 1 ? new String[] {all} : new String[] {one, all};
  }
}
