package org.toqa.fleet.floor;

import java.util.Arrays;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.ArmAction;
import org.toqa.arm.ArmFailure;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.link.message.AgentMessage.ActEnd;
import org.toqa.link.message.AgentMessage.ActFailure;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Phase;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Lets arms pick loads up and put them down: a robot that has come to the end of a phase which an
 * arm has to end is told so, until the arm has done it; only then the phase has ended. What the arm
 * does the robot tells in its hello and in each state, so that nothing of it need be remembered
 * here: whoever starts anew asks, and tells it again where the robot has forgotten it.
 */
final class ArmDispatcher {
  /** Kilograms, and a share of the load: by more a scale is not wrong. */
  private static final double SAME_LOAD = 0.05;

  private static final double SAME_SHARE = 0.05;

  private final FloorState state;
  private final FloorMissions missions;

  ArmDispatcher(FloorState state, FloorMissions missions) {
    this.state = state;
    this.missions = missions;
  }

  /** Whether its mission waits for its arm where it stands, so that it must not be moved. */
  boolean isActing(FloorRobot robot) {
    return robot.arm.isActing(state.now)
        || state
            .missions
            .missionOf(robot.name())
            .map(Mission::trouble)
            .filter(trouble -> trouble.isOfArm() && trouble.robot().equals(robot.name()))
            .isPresent();
  }

  /**
   * The robot stands at the end of its phase.
   *
   * @return false: its arm has nothing to do there
   */
  boolean begin(FloorRobot robot, Mission mission) {
    Optional<Mission.ArmTask> task = mission.armTask(robot.name());
    if (task.isEmpty() || robot.reported.capabilities().arm() == null) {
      return false;
    }
    if (!isActing(robot) && !robot.hold.isHeld() && isStored(robot, mission)) {
      robot.arm.setTold(state.now);
      robot.agent.tell(
          new RobotMessage.Act(
              mission.id(),
              mission.assignedRobot(robot.name()).map(AssignedRobot::phase).orElse(Phase.NONE),
              task.get().isPick() ? ArmAction.PICK : ArmAction.PLACE,
              task.get().target(),
              mission.task().load()));
    }
    return true;
  }

  /** What the mission is now is safe: nothing is done that a restarted server knows nothing of. */
  private boolean isStored(FloorRobot robot, Mission mission) {
    return state
        .missions
        .storedMissionOf(robot.name())
        .filter(stored -> stored.id() == mission.id() && stored.state() == mission.state())
        .isPresent();
  }

  /** What an arm was told has ended. */
  void ended(FloorRobot robot, ActEnd end) {
    Optional<Mission> mission = state.missions.get(end.task());
    Optional<Phase> phase = Phase.of(end.phase());
    if (robot.arm.end(end.act())
        && mission.isPresent()
        && phase.isPresent()
        && isDue(mission.get(), robot, phase.get(), end.action())) {
      apply(mission.get(), robot, phase.get(), end);
    }
    // written in order: acknowledged only when what follows from it is safe
    state.writer.write(
        () -> {}, () -> robot.agent.tell(new RobotMessage.AcknowledgeAct(end.act())));
  }

  private static boolean isDue(Mission mission, FloorRobot robot, Phase phase, ArmAction action) {
    return mission.assignedRobot(robot.name()).filter(c -> c.phase() == phase).isPresent()
        && mission
            .armTask(robot.name())
            .filter(task -> task.isPick() == (action == ArmAction.PICK))
            .isPresent();
  }

  private void apply(Mission mission, FloorRobot robot, Phase phase, ActEnd end) {
    Double weight = end.weight();
    if (weight != null && isOtherLoad(weight, mission.task().load())) {
      state.addToHistory(
          new EventRecord(
                  state.clock.instant(),
                  EventKind.TASK_WEIGHED,
                  mission.id(),
                  robot.name(),
                  EventRecord.SYSTEM,
                  Phrase.WEIGHS_OTHERWISE.with(robot.name(), weight, mission.task().load()))
              .onFloor(state.floor.name()));
    }
    ActFailure failure = end.failure();
    if (failure == null) {
      missions.phaseEnded(mission.id(), robot.name(), phase, mission.stopNumber(phase));
    } else {
      missions.applyEvent(
          mission.id(),
          new MissionEvent.ActFailed(
              robot.name(),
              phase,
              clause(failure, weight),
              state.formations.loadPlace(mission, robot)));
    }
  }

  private static boolean isOtherLoad(double weight, double ordered) {
    return Math.abs(weight - ordered) > Math.max(SAME_LOAD, SAME_SHARE * ordered);
  }

  private static Sentence clause(ActFailure failure, @Nullable Double weight) {
    return Arrays.stream(ArmFailure.values())
        .filter(known -> known.name().equals(failure.code()))
        .findFirst()
        .map(
            known ->
                switch (known) {
                  case TOO_FAR -> Phrase.ARM_TOO_FAR.with();
                  case TOO_NEAR -> Phrase.ARM_TOO_NEAR.with();
                  case JOINT_LIMITS -> Phrase.ARM_JOINT_LIMITS.with();
                  case NOTHING_GRASPED -> Phrase.ARM_GRASPED_NOTHING.with();
                  case NOTHING_HELD -> Phrase.ARM_HOLDS_NOTHING.with();
                  case HAND_FULL -> Phrase.ARM_HAND_FULL.with();
                  case TOO_HEAVY -> Phrase.ARM_TOO_WEAK.with(weight == null ? 0 : weight);
                  case NOT_RELEASED -> Phrase.ARM_NOT_RELEASED.with();
                  case STALLED -> Phrase.ARM_STALLED.with();
                })
        .orElseGet(() -> Phrase.ARM_SAYS.with(failure.text()));
  }
}
