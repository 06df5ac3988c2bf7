package org.toqa.fleet.floor;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.Phase;
import org.toqa.traffic.floor.DriveCommand;
import org.toqa.traffic.floor.Standstill;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Tells the traffic what each robot is to do, and the robots what the traffic decides. */
final class DriveDispatcher {
  /** A person who crosses a path is gone after this; what is not gone was looked at all round. */
  private static final Duration OBSTACLE_PATIENCE = Duration.ofSeconds(5);

  /** A robot that was put back onto its path has gone on by then. */
  private static final Duration OFF_PATH_PATIENCE = Duration.ofSeconds(1);

  /** A follower whose leader has ended says by then that it has ended too. */
  private static final Duration LEFT_BEHIND_PATIENCE = Duration.ofSeconds(2);

  /** A leader has found again by then whom it only did not hear. */
  private static final Duration SEPARATED_PATIENCE = Duration.ofSeconds(15);

  /** Robots that have picked a load up together have set out by then. */
  private static final Duration UNFOLLOWED_PATIENCE = Duration.ofSeconds(3);

  private final FloorState state;
  private final FloorMissions missions;
  private final ArmDispatcher arms;

  DriveDispatcher(FloorState state, FloorMissions missions, ArmDispatcher arms) {
    this.arms = arms;
    this.state = state;
    this.missions = missions;
  }

  /** Tells the traffic whether the robot can be moved, and where it wants to go. */
  void updateRobot(FloorRobot robot) {
    Optional<Mission> followed = state.formations.followedMission(robot.name());
    if (followed.isPresent() && robot.activeGoal() != null) {
      keepInFormation(robot, followed.get());
      return;
    }
    if (!state.traffic.hasRobot(robot.name())) {
      cancelUnwantedDrive(robot);
      return;
    }
    if (robot.manual.isActive()) {
      yieldToHand(robot);
      return;
    }
    DriveGoal goal = robot.activeGoal();
    boolean isOnOtherDrive = !robot.isStanding() && (goal == null || !robot.isDrivingTo(goal));
    boolean isStray =
        (isOnOtherDrive && !(robot.settings.isInService() && isSteppingAside(robot)))
            || updateObstructed(robot)
            || isLoadAhead(robot)
            || isCutOff(robot)
            || updateOffPath(robot)
            || updateSeparated(robot)
            || isDriveUnwanted(robot)
            || !robot.reported.report().localised();
    if (isStray) {
      cancelUnwantedDrive(robot);
    }
    Sentence objection = state.formations.objection(robot.name());
    boolean isWaiting =
        objection != null
            || robot.drive.isPostponed(state.now)
            || isAwaitingFollowers(robot)
            || isGoalOutdated(robot, goal);
    state.traffic.setMovable(
        robot.name(),
        robot.isFit() && !robot.hold.isHeld() && !isStray && !isWaiting && !arms.isActing(robot));
    state.traffic.setDiameter(robot.name(), state.diameter(robot));
    state.traffic.setFindsOwnWay(robot.name(), findsOwnWay(robot));
    state.traffic.setGoal(
        robot.name(),
        goal == null || isOnOtherDrive ? null : goal.goal(),
        goal == null ? null : heading(robot, goal),
        state.now);
    if (goal != null
        && !isWaiting
        && robot.isStanding()
        && robot.isFit()
        && state.traffic.isAtGoal(robot.name())) {
      arrived(robot, goal);
    }
    Optional<Sentence> unfollowed = unfollowed(robot);
    if (objection != null) {
      setWaitReason(robot, objection);
    } else if (unfollowed.isPresent()) {
      setWaitReason(robot, unfollowed.get());
    } else if (!isWaiting) {
      Sentence reason = goal == null ? null : trafficWaitReason(robot.name());
      if (reason != null || !robot.obedience.hasRefused()) {
        setWaitReason(robot, reason);
      }
    }
  }

  /** Whether it can, and has nothing on board that is wider than itself. */
  private boolean findsOwnWay(FloorRobot robot) {
    RobotCapabilities can = robot.reported.capabilities();
    return can.findsOwnWay() && state.diameter(robot) <= can.footprint();
  }

  /** A person drives it: it is planned nothing. */
  private void yieldToHand(FloorRobot robot) {
    state.traffic.setMovable(robot.name(), false);
    state.traffic.setDiameter(robot.name(), state.diameter(robot));
    state.traffic.setGoal(robot.name(), null, state.now);
    setWaitReason(robot, null);
  }

  /** How it shall face: as its goal says, or alone as the place says that is there. */
  private @Nullable Double heading(FloorRobot robot, DriveGoal goal) {
    boolean isInGroup = state.formations.carryingMission(robot.name()).isPresent();
    return goal.heading() == null && !isInGroup
        ? state.floor.headingAt(goal.goal())
        : goal.heading();
  }

  /** Whether it only drives to make room for others; that may end. */
  private static boolean isSteppingAside(FloorRobot robot) {
    DriveOrder order = robot.drive.order();
    return order.knownGoal() == null
        && order.storedDrive().filter(d -> d.task() == null).isPresent();
  }

  /**
   * Whether it has been stopped for a while by something on a part of its path that it cannot be
   * told otherwise any more: it is stopped, and begins anew round that.
   */
  private boolean updateObstructed(FloorRobot robot) {
    LastReport report = robot.reported.report();
    boolean isStopped =
        report.role() == Role.ALONE
            && report.mode() == Mode.DRIVING
            && report.hasError(LastReport.OBSTACLE)
            && state.traffic.isObstacleAhead(robot.name());
    return robot.obstructed.update(isStopped, OBSTACLE_PATIENCE, state.now);
  }

  /**
   * Whether a load lies by now on what it was told to drive: it is stopped, and goes round that.
   */
  private boolean isLoadAhead(FloorRobot robot) {
    return robot.reported.report().role() == Role.ALONE
        && state.leftLoads.isAhead(robot.name(), state.traffic);
  }

  /**
   * Whether another robot stands where nobody expected it and where this one was told to drive: it
   * is stopped, and both are planned anew from where they are.
   */
  private boolean isCutOff(FloorRobot robot) {
    Optional<String> other = state.traffic.cutOffBy(robot.name());
    boolean isToldNow =
        robot.reported.drive() != 0
            && !robot.drive.order().isPending()
            && !robot.drive.isCancelling();
    if (other.isPresent() && isToldNow) {
      state.addSystemLine(
          EventKind.TRAFFIC_CUT_OFF, robot.name(), Phrase.CUT_OFF.with(robot.name(), other.get()));
    }
    return other.isPresent();
  }

  /**
   * Whether it stands beside its path, or in a free zone that it does not find its way through, and
   * will not go on by that: it begins anew from where it is.
   */
  private boolean updateOffPath(FloorRobot robot) {
    LastReport report = robot.reported.report();
    boolean isOff =
        report.mode() == Mode.DRIVING
            && !report.moving()
            && (report.hasError(LastReport.OFF_WAY) || report.hasError(LastReport.ZONE_STUCK));
    if (report.hasError(LastReport.ZONE_STUCK)) {
      state.traffic.giveUpZone(robot.name());
    }
    return robot.offPath.update(isOff, OFF_PATH_PATIENCE, state.now);
  }

  /** Whether it has long sought followers in vain: it is stopped, and told anew where they are. */
  private boolean updateSeparated(FloorRobot robot) {
    return robot.separated.update(
        state.formations.isSeparated(robot), SEPARATED_PATIENCE, state.now);
  }

  /** Nobody wants its drive any more, as when a returning robot is needed elsewhere. */
  private void cancelUnwantedDrive(FloorRobot robot) {
    boolean tearsAtLoad =
        state
            .formations
            .carryingMission(robot.name())
            .filter(state.formations::isMoving)
            .isPresent();
    if (!robot.drive.order().isPending() && robot.reported.drive() != 0 && !tearsAtLoad) {
      robot.cancelDrive();
    }
  }

  /** What followed from the end of this drive is being stored, and brings another goal. */
  private boolean isGoalOutdated(FloorRobot robot, @Nullable DriveGoal goal) {
    if (goal == null) {
      return false;
    }
    Long task = goal.task();
    if (task == null) {
      return false;
    }
    Optional<Mission> mission = state.missions.get(task);
    boolean isInPhase =
        mission
            .flatMap(known -> known.assignedRobot(robot.name()))
            .filter(c -> !c.unassigned() && c.phase() == goal.phase())
            .isPresent();
    boolean isOfLeftStop =
        goal.phase().isCarryingTask()
            && mission.filter(known -> known.stopNumber(goal.phase()) == goal.stop()).isEmpty();
    return !isInPhase || isOfLeftStop;
  }

  /** Whether it drives for a task that needs it no more; what follows is being stored. */
  private boolean isDriveUnwanted(FloorRobot robot) {
    Long task = robot.drive.order().storedDrive().map(StoredDrive::task).orElse(null);
    return task != null
        && state
            .missions
            .get(task)
            .filter(mission -> !mission.isStopping())
            .flatMap(mission -> mission.assignedRobot(robot.name()))
            .filter(assigned -> !assigned.unassigned())
            .isEmpty();
  }

  /** A leader that is stopped and would begin. */
  private boolean isAwaitingFollowers(FloorRobot robot) {
    return robot.isStanding()
        && state
            .formations
            .carryingMission(robot.name())
            .filter(
                mission ->
                    !state.formations.isFollowedByAll(mission)
                        || hasEndedPhase(robot.name(), mission))
            .isPresent();
  }

  /** Whom a leader has waited for a while, whose group picked its load up and does not go on. */
  private Optional<Sentence> unfollowed(FloorRobot robot) {
    List<String> missing =
        state
            .formations
            .carryingMission(robot.name())
            .filter(mission -> robot.isStanding() && !hasEndedPhase(robot.name(), mission))
            .map(state.formations::notFollowing)
            .orElse(List.of());
    return robot.unfollowed.update(!missing.isEmpty(), UNFOLLOWED_PATIENCE, state.now)
        ? Optional.of(Phrase.WAITS_FOR_FOLLOWERS.with(Sentence.names(missing), robot.name()))
        : Optional.empty();
  }

  /** A follower has no path of its own: it is told its place, and its leader does the rest. */
  private void keepInFormation(FloorRobot robot, Mission mission) {
    boolean isWaiting = robot.drive.isPostponed(state.now);
    if (state.traffic.hasRobot(robot.name())) {
      state.traffic.setGoal(robot.name(), null, state.now);
      state.traffic.setMovable(robot.name(), false);
    }
    boolean isPickUpStored =
        state
            .missions
            .storedMissionOf(robot.name())
            .filter(stored -> stored.id() == mission.id() && stored.state() == mission.state())
            .filter(stored -> stored.progress().equals(mission.progress()))
            .isPresent();
    if (updateLeftBehind(robot, mission)) {
      endWithoutLeader(robot, mission);
      return;
    }
    if (hasEndedPhase(robot.name(), mission)
        || hasEndedPhase(Formations.leader(mission), mission)
        || isWaiting
        || robot.hold.isHeld()
        || !isPickUpStored) {
      return;
    }
    if (robot.isStanding() && robot.isFit()) {
      robot.drive.setTold(null);
      robot.agent.tell(state.formations.followOrder(mission, robot));
    } else if (isOnWayOfItsOwn(robot)) {
      robot.cancelDrive();
    }
    if (!robot.obedience.hasRefused()) {
      setWaitReason(robot, null);
    }
  }

  /** Whether a follower has a drive from before, as to make room for another robot. */
  private static boolean isOnWayOfItsOwn(FloorRobot robot) {
    return robot.reported.report().role() == Role.ALONE
        && robot.reported.drive() != 0
        && !robot.drive.order().isPending()
        && !robot.drive.isCancelling();
  }

  /**
   * Whether its leader has brought the load to the goal and ended, and it did not hear that, as
   * where the line between them was cut just then: it would wait for that leader for ever.
   */
  private boolean updateLeftBehind(FloorRobot robot, Mission mission) {
    boolean isLeftBehind =
        hasEndedPhase(Formations.leader(mission), mission)
            && !hasEndedPhase(robot.name(), mission)
            && !mission.isStopping()
            && robot.isHeard()
            && !robot.reported.isMoving();
    return robot.leftBehind.update(isLeftBehind, LEFT_BEHIND_PATIENCE, state.now);
  }

  private void endWithoutLeader(FloorRobot robot, Mission mission) {
    if (robot.isStanding()) {
      missions.phaseEnded(mission.id(), robot.name(), Phase.TO_GOAL, mission.stopNumber());
    } else if (robot.reported.drive() != 0) {
      robot.cancelDrive();
    }
  }

  private static boolean hasEndedPhase(String robot, Mission mission) {
    return mission.assignedRobot(robot).filter(AssignedRobot::isDriving).isEmpty();
  }

  private void arrived(FloorRobot robot, DriveGoal goal) {
    if (goal.task() == null) {
      if (!robot.charging.hasTurn()) { // else it stays while it charges
        robot.drive.dropGoalWithoutTask();
        state.changed = true;
      }
    } else {
      long task = goal.task();
      if (state.missions.get(task).filter(mission -> arms.begin(robot, mission)).isPresent()) {
        return;
      }
      List<String> together =
          state
              .formations
              .carryingMission(robot.name())
              .map(mission -> mission.assignedRobots().stream().map(AssignedRobot::robot).toList())
              .orElse(List.of(robot.name()));
      together.forEach(r -> missions.phaseEnded(task, r, goal.phase(), goal.stop()));
    }
  }

  /** Why the traffic does not let it go on, and what a person can do about that, if anything. */
  private @Nullable Sentence trafficWaitReason(String name) {
    Sentence reason = state.traffic.waitReason(name);
    if (reason == null) {
      return null;
    }
    return state
        .traffic
        .blockingRobot(name)
        .map(state.robots::get)
        .flatMap(this::cause)
        .or(() -> loadInTheWay(name))
        .<Sentence>map(cause -> Phrase.LISTED_APART.with(reason, cause))
        .orElse(reason);
  }

  private Optional<Sentence> loadInTheWay(String name) {
    return state
        .traffic
        .obstacleInTheWay(name)
        .flatMap(
            place ->
                state
                    .leftLoads
                    .taskAt(place)
                    .map(Phrase.LOAD_IN_THE_WAY::with)
                    .or(() -> state.leftLoads.boxAt(place).map(Phrase.BOX_IN_THE_WAY::with)));
  }

  /** Why a robot that others wait for does not go on, where a person can help. */
  private Optional<Sentence> cause(FloorRobot robot) {
    @Nullable Phrase phrase =
        robot.hold.isHeld()
            ? Phrase.STANDS_ON_HOLD
            : switch (robot.state()) {
              case OUT_OF_SERVICE ->
                  robot.isHeard() ? Phrase.STANDS_OUT_OF_SERVICE : Phrase.STANDS_UNHEARD;
              case CONNECTING, LOST -> Phrase.STANDS_UNHEARD;
              case NOT_LOCALISED -> Phrase.STANDS_NOT_LOCALISED;
              case ERROR -> Phrase.STANDS_WITH_ERROR;
              case IDLE, HOLDING, CHARGING -> null;
              case DRIVING -> isStandingStill(robot) ? Phrase.STANDS_STILL : null;
            };
    return Optional.ofNullable(phrase).map(known -> known.with(robot.name()));
  }

  private boolean isStandingStill(FloorRobot robot) {
    return state.traffic.standstills().stream()
        .anyMatch(
            standstill ->
                standstill.kind() == Standstill.Kind.NOT_MOVING
                    && standstill.robots().contains(robot.name()));
  }

  private void setWaitReason(FloorRobot robot, @Nullable Sentence reason) {
    state.changed |= robot.drive.setWaitReason(reason);
  }

  /** Lets the traffic decide. */
  void applyTrafficDecisions() {
    for (DriveCommand decision : state.traffic.decide(state.now)) {
      FloorRobot robot = state.robots.get(decision.robot());
      if (robot != null) {
        sendDecision(robot, decision);
        state.changed = true;
      }
    }
  }

  void sendDecision(FloorRobot robot, DriveCommand decision) {
    switch (decision) {
      case DriveCommand.Begin begin -> {
        DriveGoal goal = robot.drive.goal();
        robot.drive.setTold(goal == null ? null : goal.goal());
        robot.agent.tell(
            new RobotMessage.Drive(
                goal == null ? null : goal.task(),
                goal == null ? Phase.NONE : goal.phase(),
                begin.trajectory(),
                begin.released(),
                begin.endsAtGoal(),
                goal == null ? 0 : goal.load(),
                state
                    .formations
                    .carryingMission(robot.name())
                    .map(state.formations::leadOrder)
                    .orElse(null)));
      }
      case DriveCommand.Extend extend ->
          robot.agent.tell(
              new RobotMessage.Extend(
                  extend.from(), extend.segments(), extend.released(), extend.endsAtGoal()));
      case DriveCommand.Release release ->
          robot.agent.tell(new RobotMessage.Release(release.released()));
      case DriveCommand.Room lent -> {
        robot.room.lend();
        robot.agent.tell(new RobotMessage.LendRoom(lent.room()));
      }
    }
  }
}
