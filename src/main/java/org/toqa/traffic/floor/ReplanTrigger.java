package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.List;

/** Says when the robots of a floor have to be planned together again. */
final class ReplanTrigger {
  private static final Duration NO_PROGRESS_AFTER = Duration.ofSeconds(10);
  private static final Duration PLAN_AGAIN_AFTER = Duration.ofSeconds(5);

  /** Whether something changed since the robots were last planned together. */
  private boolean changed = true;

  /** Whether a robot gave up a part of its path that others wait for it to drive. */
  private boolean mustReplan;

  /** When any robot last completed a section. */
  private Instant lastProgress = Instant.MIN;

  private Instant lastJointPlan = Instant.MIN;

  void markChanged() {
    changed = true;
  }

  boolean isChanged() {
    return changed;
  }

  /** To be called before a robot gives up what it was not released. */
  void markFreed(TrafficRobot robot) {
    mustReplan |= robot.drive.hasUnreleased();
  }

  /** A robot completed a section. */
  void recordProgress(Instant now) {
    lastProgress = now;
  }

  /** Whether paths were given up that others wait for, or nobody gets on. */
  boolean mustReplan() {
    return mustReplan;
  }

  /** Whether to plan now; counts as planned from now on. */
  boolean takePlanNeeded(
      Collection<TrafficRobot> robots, List<Standstill> standstills, Instant now) {
    mustReplan |= hasStandstill(robots, standstills, now);
    boolean isNeeded = mustReplan || robots.stream().anyMatch(TrafficRobot::needsPath);
    if (!isNeeded || !(changed || lastJointPlan.plus(PLAN_AGAIN_AFTER).isBefore(now))) {
      return false;
    }
    lastJointPlan = now;
    changed = false;
    return true;
  }

  /** All robots have paths by a new plan. */
  void recordPlanned() {
    mustReplan = false;
  }

  /** Whether robots wait in a circle, or have paths and none has got on for long. */
  private boolean hasStandstill(
      Collection<TrafficRobot> robots, List<Standstill> standstills, Instant now) {
    boolean isCycle =
        standstills.stream().anyMatch(s -> s.kind() == Standstill.Kind.CYCLE_OF_WAITS);
    return isCycle
        || (lastProgress.plus(NO_PROGRESS_AFTER).isBefore(now)
            && robots.stream().anyMatch(robot -> robot.drive.hasUnreleased())
            && robots.stream().noneMatch(robot -> robot.drive.isDriving() && !robot.isStalled()));
  }
}
