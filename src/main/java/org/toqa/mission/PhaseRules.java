package org.toqa.mission;

import java.util.List;
import java.util.stream.Stream;
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
        .step(
            List.of(),
            mission.task().isDrive()
                ? Phrase.SET_OUT_FOR.with(event.robot(), mission.objectSentence())
                : Phrase.SET_OUT.with(event.robot()));
  }

  static Mission.Step onPhaseEnded(Mission mission, MissionEvent.PhaseEnded event) {
    AssignedRobot assigned = mission.assignedRobot(event.robot()).orElseThrow();
    if (assigned.phase() != event.phase()
        || assigned.arrived()
        || mission.isStopping()
        || isOfOtherStop(mission, event)) {
      return mission.unchangedStep();
    }
    Mission arrived = withoutTroubleOf(event.robot(), mission);
    arrived = arrived.withRobotChanged(event.robot(), AssignedRobot::withArrived);
    return switch (event.phase()) {
      case TO_OBJECT -> arriveAtObject(arrived, event);
      case TO_GOAL -> arriveAtDestination(arrived, event);
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

  /** One that was told twice has nothing to do with the next stop. */
  private static boolean isOfOtherStop(Mission mission, MissionEvent.PhaseEnded event) {
    boolean isAlongStops =
        event.phase() == (mission.task().isDrive() ? Phase.TO_OBJECT : Phase.TO_GOAL);
    return isAlongStops
        && mission.ending() == null
        && event.stop() != mission.stopNumber(event.phase());
  }

  private static Mission.Step arriveAtObject(Mission mission, MissionEvent.PhaseEnded event) {
    Sentence one = Phrase.IS_AT_LOAD.with(event.robot());
    if (!isComplete(mission)) {
      return mission.withState(TaskState.TO_OBJECT).step(List.of(), one);
    }
    return mission.isToWaitAtObject()
        ? waitAt(
            mission.stopNumber(Phase.TO_OBJECT), mission.withState(TaskState.TO_OBJECT), one, event)
        : leaveObject(mission, ofSeveral(mission, one));
  }

  /** Its robots, all at the load, drive on with it; a drive's robot drives on. */
  static Mission.Step leaveObject(Mission mission, List<Sentence> before) {
    return mission.task().isDrive() ? driveOn(mission, before) : pickUp(mission, before);
  }

  /** To the next stop, or home from the last one. */
  private static Mission.Step driveOn(Mission mission, List<Sentence> before) {
    Sentence where = mission.objectSentence();
    if (mission.isDriveAtLastStop()) {
      return goHome(mission, followed(before, Phrase.DRIVE_ENDED.with(where)));
    }
    int next = mission.progress().stop() + 1;
    Mission going =
        mission
            .withAssignedRobots(inPhase(mission, Phase.TO_OBJECT))
            .withProgress(mission.progress().at(next, null))
            .withState(TaskState.TO_OBJECT);
    return going.step(
        going.driveCommands(Phase.TO_OBJECT), followed(before, leaves(where, next, mission)));
  }

  private static Sentence leaves(Sentence where, int next, Mission mission) {
    return Phrase.LEAVES_STOP.with(where, next, mission.task().route().size());
  }

  private static Mission.Step goHome(Mission mission, Sentence[] history) {
    Mission returning =
        mission
            .withAssignedRobots(inPhase(mission, Phase.HOME))
            .withState(TaskState.RETURNING)
            .withLoadAt(null)
            .withTrouble(null);
    return returning.step(returning.driveCommands(Phase.HOME), history);
  }

  private static Mission.Step pickUp(Mission mission, List<Sentence> before) {
    Mission carrying =
        mission
            .withAssignedRobots(inPhase(mission, Phase.TO_GOAL))
            .withProgress(StopProgress.fetched(mission.stopNumber()))
            .withState(TaskState.CARRYING);
    return carrying.step(
        carrying.driveCommands(Phase.TO_GOAL),
        followed(before, Phrase.PICKED_UP.with(mission.object().sentence())));
  }

  private static Mission.Step waitAt(
      int stop, Mission mission, Sentence one, MissionEvent.PhaseEnded event) {
    Mission waiting = mission.withProgress(mission.progress().at(stop, event.at()));
    Stop at = waiting.waitingStop().orElseThrow();
    Phrase phrase = at.charge() == null ? Phrase.WAITS_AT_STOP : Phrase.CHARGES_AT_STOP;
    return waiting.step(List.of(), followed(ofSeveral(mission, one), phrase.with(at.sentence())));
  }

  /** Its robots, all at a stop with the load, drive on, or home from the last one. */
  static Mission.Step leaveStop(Mission mission, List<Sentence> before) {
    Sentence where = mission.destinationSentence();
    if (mission.isAtLastStop()) {
      return goHome(mission, followed(before, Phrase.DELIVERED.with(where)));
    }
    int next = mission.stopNumber() + 1;
    Mission going =
        mission
            .withAssignedRobots(inPhase(mission, Phase.TO_GOAL))
            .withProgress(mission.progress().at(next, null));
    return going.step(
        going.driveCommands(Phase.TO_GOAL), followed(before, leaves(where, next, mission)));
  }

  private static Mission.Step arriveAtDestination(Mission mission, MissionEvent.PhaseEnded event) {
    String robot = event.robot();
    Sentence where = mission.destination().sentence();
    if (mission.ending() == LoadChoice.BACK) {
      return isComplete(mission)
          ? mission
              .withLoadAt(null)
              .unassignAll(
                  TaskState.CANCELLED, Phrase.BROUGHT_BACK.with(where), Phrase.CANCELLED.with())
          : mission.step(List.of(), Phrase.IS_BACK_AT_START.with(robot));
    }
    Sentence one =
        mission.isAtLastStop()
            ? Phrase.IS_AT_GOAL.with(robot)
            : Phrase.IS_AT_STOP.with(robot, where);
    if (!isComplete(mission)) {
      return mission.step(List.of(), one);
    }
    return mission.isToWaitAhead()
        ? waitAt(mission.stopNumber(), mission, one, event)
        : leaveStop(mission, ofSeveral(mission, one));
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

  /** Of one robot alone it is told what that leads to. */
  private static List<Sentence> ofSeveral(Mission mission, Sentence one) {
    return mission.assignedRobots().size() == 1 ? List.of() : List.of(one);
  }

  private static Sentence[] followed(List<Sentence> before, Sentence last) {
    return Stream.concat(before.stream(), Stream.of(last)).toArray(Sentence[]::new);
  }
}
