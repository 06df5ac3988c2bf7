package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * Gives paths to the robots that need one: has them planned by other threads, from a picture of the
 * floor, and adopts what still fits when that is done. One plan is made at a time; what comes up
 * meanwhile is in the next picture. Confined to one thread, and waits for none.
 */
final class PathAssigner {
  /** Who waits for a plan that takes so long is told that. */
  private static final Duration LATE_AFTER = Duration.ofSeconds(2);

  private final Map<String, TrafficRobot> robots;
  private final ReplanTrigger trigger;
  private final FloorPlanner planner;
  private final Executor planning;
  private final PlanAdopter adopter;
  private @Nullable Pending pending;

  private record Pending(PlanningRequest request, CompletableFuture<FloorPlan> plan) {}

  /**
   * @param robots all on the floor by name, as they are at any time
   * @param planning what plans; it may do so at once
   */
  PathAssigner(
      Map<String, TrafficRobot> robots,
      Claims claims,
      ReplanTrigger trigger,
      FloorPlanner planner,
      Executor planning) {
    this.robots = robots;
    this.trigger = trigger;
    this.planner = planner;
    this.planning = planning;
    this.adopter = new PlanAdopter(robots, claims, trigger);
  }

  /** Whether robots are being planned together. */
  boolean isPlanningJointly() {
    return pending != null && pending.request().need().isDue();
  }

  /** Whether a plan that is being made was asked for so long ago. */
  boolean isPlanningFor(Duration time, Instant now) {
    return pending != null && !pending.request().now().plus(time).isAfter(now);
  }

  private void updateWaits(Instant now) {
    boolean isPlanLate = isPlanningFor(LATE_AFTER, now);
    for (TrafficRobot robot : robots.values()) {
      Vec2 goal = robot.goal();
      if (goal == null || !robot.isMovable()) {
        robot.waiting.restartStanding(now);
      }
      if (!robot.needsPath() || goal == null) {
        robot.waiting.clearNoPathReason();
        continue;
      }
      if (robot.waiting.since() == null) {
        robot.waiting.setSince(now);
      }
      if (isPlanLate && robot.waiting.noPathReason() == null) {
        robot.waiting.setNoPathReason(new WaitReason.NoPlan(goal), now);
      }
    }
  }

  /**
   * Pictures the floor and has paths planned, if any are needed and no plan is being made.
   *
   * @param standstills those that are known now
   * @return whether it did
   */
  boolean requestPlan(List<Standstill> standstills, Obstacles obstacles, Instant now) {
    updateWaits(now);
    if (pending != null) {
      return false;
    }
    ReplanTrigger.Need need = trigger.need(robots.values(), standstills, now);
    List<TrafficRobot> unserved = robots.values().stream().filter(TrafficRobot::needsPath).toList();
    boolean isAnyChange = trigger.isChanged() && !trigger.isPlannedAhead();
    Set<String> dueForOwnPath =
        unserved.stream()
            .filter(
                robot ->
                    isAnyChange
                        || robot.waiting.isSinglePlanOlderThan(FloorPlanner.RETRY_AFTER, now))
            .map(robot -> robot.name)
            .collect(Collectors.toSet());
    boolean isReasonDue =
        unserved.stream()
            .anyMatch(
                robot -> robot.waiting.isNoPathReasonOlderThan(FloorPlanner.RETRY_AFTER, now));
    boolean isJointPlanDue = need.isDue() && need.isOf(robots.values());
    if (dueForOwnPath.isEmpty() && !isReasonDue && !isJointPlanDue) {
      return false;
    }
    unserved.stream()
        .filter(robot -> dueForOwnPath.contains(robot.name))
        .forEach(robot -> robot.waiting.recordSinglePlan(now));
    trigger.recordRequest();
    PlanningRequest request =
        new PlanningRequest(
            now,
            obstacles,
            robots.values().stream().map(TrafficRobot::copy).toList(),
            dueForOwnPath,
            need);
    pending =
        new Pending(request, CompletableFuture.supplyAsync(() -> planner.plan(request), planning));
    return true;
  }

  /**
   * Adopts the plan that is being made, if it is ready.
   *
   * @param obstacles those that are there now
   */
  void adoptPlan(Obstacles obstacles, Instant now) {
    Pending ready = pending;
    if (ready == null || !ready.plan().isDone()) {
      return;
    }
    pending = null;
    FloorPlan plan = result(ready);
    boolean isWhole = adopter.adopt(plan, obstacles.cells());
    trigger.recordPlan(plan, isWhole);
    if (plan.isJoint()) {
      robots.values().stream()
          .filter(TrafficRobot::hasPathToGoal)
          .forEach(robot -> robot.waiting.endWaitForPath());
    }
    updateWaits(now);
  }

  private FloorPlan result(Pending ready) {
    try {
      return ready.plan().join();
    } catch (CompletionException e) {
      trigger.recordFailure(ready.request());
      switch (e.getCause()) {
        case RuntimeException cause -> throw cause;
        case Error cause -> throw cause;
        case null, default -> throw e;
      }
    }
  }
}
