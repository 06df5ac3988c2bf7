package org.toqa.fleet;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorRobot.Errand;
import org.toqa.mission.MissionEvent;
import org.toqa.traffic.floor.Decision;

/** Tells the traffic what each robot is to do, and the robots what the traffic decides. */
final class Driving {
  private final FloorState state;
  private final FloorMissions missions;

  Driving(FloorState state, FloorMissions missions) {
    this.state = state;
    this.missions = missions;
  }

  /** Tells the traffic whether the robot can be moved, and where it wants to go. */
  void direct(FloorRobot robot) {
    if (!state.traffic.knows(robot.name())) {
      return;
    }
    Errand errand = robot.duty();
    boolean isOnOtherWay = !robot.isStanding() && (errand == null || !robot.isOnTheWayOf(errand));
    boolean mayEnd = robot.told != null && robot.told.task() == null && robot.toldGoal == null;
    boolean isStray = isOnOtherWay && !(robot.inService && mayEnd);
    if (isStray && !robot.driveUnderway && robot.drive != 0) {
      robot
          .cancelDrive(); // nobody wants it any more, as when a returning robot is needed elsewhere
    }
    boolean isWaiting = robot.notBefore.isAfter(state.now);
    state.traffic.isFixed(
        robot.name(), !robot.isFit() || robot.holdReason != null || isStray || isWaiting);
    state.traffic.wants(
        robot.name(), errand == null || isOnOtherWay ? null : errand.goal(), state.now);
    if (errand != null
        && robot.isStanding()
        && robot.isFit()
        && state.traffic.isAtGoal(robot.name())) {
      arrived(robot, errand);
    }
    if (!isWaiting) {
      note(robot, errand == null ? null : state.traffic.reason(robot.name()));
    }
  }

  private void arrived(FloorRobot robot, Errand errand) {
    if (errand.task() == null) {
      if (robot.turn == null) { // else it stays while it charges
        robot.errand = null;
        state.changed = true;
      }
    } else {
      missions.happened(errand.task(), new MissionEvent.PhaseEnded(robot.name(), errand.phase()));
    }
  }

  private void note(FloorRobot robot, @Nullable String reason) {
    if (!Objects.equals(robot.trouble, reason)) {
      robot.trouble = reason;
      state.changed = true;
    }
  }

  /** Lets the traffic decide. */
  void decide() {
    for (Decision decision : state.traffic.decide(state.now)) {
      FloorRobot robot = state.robots.get(decision.robot());
      if (robot != null) {
        tell(robot, decision);
        state.changed = true;
      }
    }
  }

  private static void tell(FloorRobot robot, Decision decision) {
    switch (decision) {
      case Decision.Begin begin -> {
        Errand errand = robot.errand;
        robot.driveUnderway = true;
        robot.toldGoal = errand == null ? null : errand.goal();
        robot.agent.tell(
            new RobotMessage.Drive(
                errand == null ? null : errand.task(),
                errand == null ? 0 : errand.phase(),
                begin.way(),
                begin.released(),
                begin.last(),
                errand == null ? 0 : errand.load()));
      }
      case Decision.Extend extend ->
          robot.agent.tell(
              new RobotMessage.Extend(
                  extend.from(), extend.segments(), extend.released(), extend.last()));
      case Decision.Release release ->
          robot.agent.tell(new RobotMessage.Release(release.released()));
    }
  }
}
