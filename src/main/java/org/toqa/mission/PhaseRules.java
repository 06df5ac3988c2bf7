package org.toqa.mission;

import java.util.List;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** How a mission goes on while its robots do what they should. */
final class PhaseRules {
  private PhaseRules() {}

  static Mission.Step onDriveStarted(Mission mission, MissionEvent.DriveStarted event) {
    if (mission.state() != TaskState.ASSIGNED || event.phase() != Phase.TO_OBJECT) {
      return mission.unchangedStep();
    }
    return mission
        .withState(TaskState.TO_OBJECT)
        .step(List.of(), Phrase.SET_OUT.with(event.robot()));
  }

  static Mission.Step onPhaseEnded(Mission mission, MissionEvent.PhaseEnded event) {
    AssignedRobot assigned = mission.assignedRobot(event.robot()).orElseThrow();
    if (assigned.phase() != event.phase() || assigned.arrived() || mission.isStopping()) {
      return mission.unchangedStep();
    }
    Mission arrived = withoutTroubleOf(event.robot(), mission);
    arrived = arrived.withRobotChanged(event.robot(), AssignedRobot::withArrived);
    return switch (event.phase()) {
      case TO_OBJECT -> arriveAtObject(arrived, Phrase.IS_AT_LOAD.with(event.robot()));
      case TO_GOAL -> arriveAtDestination(arrived, event.robot());
      case HOME, NONE -> arrived.unassign(event.robot(), Phrase.HAS_PARKED.with(event.robot()));
    };
  }

  static Mission.Step onRetasked(Mission mission, MissionEvent.Retasked event) {
    return mission.phaseOf(event.robot()) == Phase.HOME
        ? mission.unassign(event.robot(), Phrase.TOOK_ANOTHER.with(event.robot()))
        : mission.unchangedStep();
  }

  static Mission.Step onExchanged(Mission mission, MissionEvent.Exchanged event) {
    if (!mission.isExchangeable()) {
      return mission.unchangedStep();
    }
    return mission
        .withAssignedRobots(List.of(AssignedRobot.of(event.newRobot())))
        .withState(TaskState.ASSIGNED)
        .step(
            List.of(
                new MissionCommand.Unassign(event.robot()),
                new MissionCommand.Drive(event.newRobot(), Phase.TO_OBJECT)),
            Phrase.GIVEN_INSTEAD.with(event.newRobot(), event.robot(), event.why()));
  }

  static Mission.Step onStopped(Mission mission, MissionEvent.Stopped event) {
    AssignedRobot assigned = mission.assignedRobot(event.robot()).orElseThrow();
    if (!mission.isStopping() || assigned.arrived()) {
      return mission.unchangedStep();
    }
    Mission stopped = mission.withRobotChanged(event.robot(), AssignedRobot::withArrived);
    if (!isComplete(stopped)) {
      return stopped.step(List.of(), Phrase.HAS_STOPPED.with(event.robot()));
    }
    return stopped
        .withLoadAt(event.place())
        .unassignAll(
            TaskState.CANCELLED,
            Phrase.SET_DOWN.with(event.place().sentence()),
            Phrase.CANCELLED.with());
  }

  private static Mission.Step arriveAtObject(Mission mission, Sentence one) {
    if (!isComplete(mission)) {
      return mission.withState(TaskState.TO_OBJECT).step(List.of(), one);
    }
    Mission carrying =
        mission.withAssignedRobots(inPhase(mission, Phase.TO_GOAL)).withState(TaskState.CARRYING);
    return carrying.step(
        carrying.driveCommands(Phase.TO_GOAL),
        sentences(mission, one, Phrase.PICKED_UP.with(mission.object().sentence())));
  }

  private static Mission.Step arriveAtDestination(Mission mission, String robot) {
    Sentence where = mission.destination().sentence();
    if (mission.ending() == LoadChoice.BACK) {
      return isComplete(mission)
          ? mission
              .withLoadAt(null)
              .unassignAll(
                  TaskState.CANCELLED, Phrase.BROUGHT_BACK.with(where), Phrase.CANCELLED.with())
          : mission.step(List.of(), Phrase.IS_BACK_AT_START.with(robot));
    }
    Sentence one = Phrase.IS_AT_GOAL.with(robot);
    if (!isComplete(mission)) {
      return mission.step(List.of(), one);
    }
    Mission returning =
        mission
            .withAssignedRobots(inPhase(mission, Phase.HOME))
            .withState(TaskState.RETURNING)
            .withLoadAt(null)
            .withTrouble(null);
    return returning.step(
        returning.driveCommands(Phase.HOME), sentences(mission, one, Phrase.DELIVERED.with(where)));
  }

  private static Mission withoutTroubleOf(String robot, Mission mission) {
    Trouble trouble = mission.trouble();
    return trouble != null && trouble.robot().equals(robot) ? mission.withTrouble(null) : mission;
  }

  private static boolean isComplete(Mission mission) {
    return mission.assignedRobots().stream().allMatch(c -> c.arrived() || c.unassigned());
  }

  private static List<AssignedRobot> inPhase(Mission mission, Phase phase) {
    return mission.assignedRobots().stream()
        .map(c -> c.unassigned() ? c : c.withPhase(phase))
        .toList();
  }

  private static Sentence[] sentences(Mission mission, Sentence one, Sentence all) {
    return mission.assignedRobots().size() == 1 ? new Sentence[] {all} : new Sentence[] {one, all};
  }
}
