package org.toqa.fleet;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorRobot.Errand;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.mission.Carrier;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.traffic.floor.Decision;
import org.toqa.wording.Sentence;

/** Tells the traffic what each robot is to do, and the robots what the traffic decides. */
final class Driving {
  /** Who walks across a way is gone again after this; and what is not was looked at all round. */
  private static final Duration PASSING = Duration.ofSeconds(5);

  /** The robot's word that it stands before something. */
  private static final String OBSTACLE = "OBSTACLE";

  private final FloorState state;
  private final FloorMissions missions;

  Driving(FloorState state, FloorMissions missions) {
    this.state = state;
    this.missions = missions;
  }

  /** Tells the traffic whether the robot can be moved, and where it wants to go. */
  void direct(FloorRobot robot) {
    Optional<Mission> followed = state.formations.following(robot.name());
    if (followed.isPresent() && robot.duty() != null) {
      keepInFormation(robot, followed.get());
      return;
    }
    if (!state.traffic.knows(robot.name())) {
      cancelWhenAllStand(robot);
      return;
    }
    Errand errand = robot.duty();
    boolean isOnOtherWay = !robot.isStanding() && (errand == null || !robot.isOnTheWayOf(errand));
    boolean mayEnd = robot.told != null && robot.told.task() == null && robot.toldGoal == null;
    boolean isStray = (isOnOtherWay && !(robot.inService && mayEnd)) || isObstructed(robot);
    if (isStray) {
      cancelWhenAllStand(robot);
    }
    boolean isWaiting =
        robot.notBefore.isAfter(state.now) || isAwaitingFollowers(robot) || isOver(robot, errand);
    state.traffic.isFixed(
        robot.name(), !robot.isFit() || robot.holdReason != null || isStray || isWaiting);
    state.traffic.wants(
        robot.name(),
        errand == null || isOnOtherWay ? null : errand.goal(),
        errand == null ? null : errand.heading(),
        state.now);
    if (errand != null
        && !isWaiting
        && robot.isStanding()
        && robot.isFit()
        && state.traffic.isAtGoal(robot.name())) {
      arrived(robot, errand);
    }
    if (!isWaiting) {
      note(robot, errand == null ? null : state.traffic.reason(robot.name()));
    }
  }

  /**
   * Whether it has stood for a while before something on a part of its way that it cannot be told
   * otherwise any more: it is stopped, and begins anew round that.
   */
  private boolean isObstructed(FloorRobot robot) {
    boolean isStopped =
        robot.role == Role.ALONE
            && robot.mode == Mode.DRIVING
            && robot.errors.stream().anyMatch(fault -> fault.code().equals(OBSTACLE))
            && state.traffic.isHeadingForObstacle(robot.name());
    if (!isStopped) {
      robot.obstructedSince = null;
    } else if (robot.obstructedSince == null) {
      robot.obstructedSince = state.now;
    }
    return robot.obstructedSince != null && !robot.obstructedSince.plus(PASSING).isAfter(state.now);
  }

  /** Nobody wants its drive any more, as when a returning robot is needed elsewhere. */
  private void cancelWhenAllStand(FloorRobot robot) {
    boolean tearsAtLoad =
        state.formations.carrying(robot.name()).filter(state.formations::isMoving).isPresent();
    if (!robot.driveUnderway && robot.drive != 0 && !tearsAtLoad) {
      robot.cancelDrive();
    }
  }

  /** What followed from the end of this errand is being stored, and brings another one. */
  private boolean isOver(FloorRobot robot, @Nullable Errand errand) {
    if (errand == null) {
      return false;
    }
    Long task = errand.task();
    return task != null
        && state
            .missions
            .get(task)
            .flatMap(mission -> mission.carrier(robot.name()))
            .filter(c -> !c.released() && c.phase() == errand.phase())
            .isEmpty();
  }

  /** A leader that stands and would begin. */
  private boolean isAwaitingFollowers(FloorRobot robot) {
    return robot.isStanding()
        && state
            .formations
            .carrying(robot.name())
            .filter(
                mission -> !state.formations.allFollow(mission) || hasEnded(robot.name(), mission))
            .isPresent();
  }

  /** A follower has no way of its own: it is told its place, and its leader does the rest. */
  private void keepInFormation(FloorRobot robot, Mission mission) {
    boolean isWaiting = robot.notBefore.isAfter(state.now);
    if (state.traffic.knows(robot.name())) {
      state.traffic.wants(robot.name(), null, state.now);
      state.traffic.isFixed(robot.name(), true);
    }
    if (hasEnded(robot.name(), mission) || isWaiting || robot.holdReason != null) {
      return;
    }
    if (robot.isStanding() && robot.isFit()) {
      robot.driveUnderway = true;
      robot.toldGoal = null;
      robot.agent.tell(state.formations.follow(mission, robot));
    }
    note(robot, null);
  }

  private static boolean hasEnded(String robot, Mission mission) {
    return mission.carrier(robot).filter(Carrier::isDriving).isEmpty();
  }

  private void arrived(FloorRobot robot, Errand errand) {
    if (errand.task() == null) {
      if (robot.turn == null) { // else it stays while it charges
        robot.errand = null;
        state.changed = true;
      }
    } else {
      long task = errand.task();
      List<String> together =
          state
              .formations
              .carrying(robot.name())
              .map(mission -> mission.carriers().stream().map(Carrier::robot).toList())
              .orElse(List.of(robot.name()));
      together.forEach(
          r -> missions.happened(task, new MissionEvent.PhaseEnded(r, errand.phase())));
    }
  }

  private void note(FloorRobot robot, @Nullable Sentence reason) {
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

  private void tell(FloorRobot robot, Decision decision) {
    switch (decision) {
      case Decision.Begin begin -> {
        Errand errand = robot.errand;
        robot.driveUnderway = true;
        robot.toldGoal = errand == null ? null : errand.goal();
        state
            .formations
            .carrying(robot.name())
            .ifPresent(mission -> robot.agent.tell(state.formations.lead(mission)));
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
