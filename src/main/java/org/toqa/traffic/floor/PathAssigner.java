package org.toqa.traffic.floor;

import static java.util.Comparator.nullsLast;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;

/**
 * Gives paths to the robots that need one: first each its own, then all together where that helps,
 * and to those without one the reason, and room by others that step aside. Confined to one thread.
 */
final class PathAssigner {
  private static final Duration RETRY_AFTER = Duration.ofSeconds(1);

  private final Map<String, TrafficRobot> robots;
  private final Claims claims;
  private final ReplanTrigger trigger;
  private final SingleRobotPlanner singleRobotPlanner;
  private final LanePlanner lanePlanner;
  private final WaitReasonFinder waitReasons;
  private final RoomMaker roomMaker;

  /**
   * @param robots all on the floor by name, as they are at any time
   */
  PathAssigner(
      Map<String, TrafficRobot> robots,
      Claims claims,
      ReplanTrigger trigger,
      SingleRobotPlanner singleRobotPlanner,
      LanePlanner lanePlanner,
      WaitReasonFinder waitReasons) {
    this.robots = robots;
    this.claims = claims;
    this.trigger = trigger;
    this.singleRobotPlanner = singleRobotPlanner;
    this.lanePlanner = lanePlanner;
    this.waitReasons = waitReasons;
    this.roomMaker = new RoomMaker(singleRobotPlanner, robots, trigger);
  }

  /**
   * @param standstills those that are known now
   */
  void assignPaths(List<Standstill> standstills, Instant now) {
    planSingleRobots(now);
    planJointly(standstills, now);
    findWaitReasons(now);
    robots.values().stream()
        .filter(TrafficRobot::needsPath)
        .forEach(robot -> roomMaker.makeRoomFor(robot, now));
  }

  /** Gives their own paths to those that wait: formations first, then the longest waiting. */
  private void planSingleRobots(Instant now) {
    List<TrafficRobot> unserved =
        robots.values().stream()
            .filter(TrafficRobot::needsPath)
            .sorted(
                Comparator.<TrafficRobot, Boolean>comparing(robot -> !robot.isFormation())
                    .thenComparing(
                        robot -> robot.waiting.since(),
                        nullsLast(Comparator.<Instant>naturalOrder())))
            .toList();
    for (TrafficRobot robot : unserved) {
      if (robot.waiting.since() == null) {
        robot.waiting.setSince(now);
      }
      if ((trigger.isChanged() && !trigger.isPlannedAhead())
          || robot.waiting.isSinglePlanOlderThan(RETRY_AFTER, now)) {
        robot.waiting.recordSinglePlan(now);
        planSingleRobot(robot);
      }
    }
  }

  private void planSingleRobot(TrafficRobot robot) {
    List<SweptArea> claimed = new ArrayList<>(robot.claimedByOthers(robots.values()));
    robots.values().stream()
        .filter(other -> other.hasPrecedenceOver(robot))
        .forEach(other -> claimed.addAll(other.waiting.wanted()));
    singleRobotPlanner
        .pathAmong(robot, claimed)
        .ifPresent(
            sections -> {
              robot.continueOn(ReservedPath.independent(robot.releasedEnd(), sections));
              robot.waiting.restart(null);
            });
  }

  private void planJointly(List<Standstill> standstills, Instant now) {
    if (!trigger.takePlanNeeded(robots.values(), standstills, now)) {
      return;
    }
    LanePlanner.Outcome outcome =
        lanePlanner.plan(robots.values(), claims, trigger.mustReplan(), trigger.isStill(), now);
    if (outcome == LanePlanner.Outcome.PLANNED || outcome == LanePlanner.Outcome.PLANNED_AHEAD) {
      trigger.recordPlanned(outcome == LanePlanner.Outcome.PLANNED_AHEAD);
      robots.values().stream()
          .filter(TrafficRobot::hasPathToGoal)
          .forEach(robot -> robot.waiting.endWaitForPath());
    }
  }

  private void findWaitReasons(Instant now) {
    for (TrafficRobot robot : robots.values()) {
      if (!robot.needsPath()) {
        robot.waiting.clearNoPathReason();
      } else if (robot.waiting.isNoPathReasonOlderThan(RETRY_AFTER, now)) {
        robot.waiting.setNoPathReason(waitReasons.reasonFor(robot, robots.values()), now);
      }
    }
  }
}
