package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.List;

/** Says when the robots of a floor have to be planned together again. */
final class ReplanTrigger {
  private static final Duration NO_PROGRESS_AFTER = Duration.ofSeconds(10);
  private static final Duration PLAN_AGAIN_AFTER = Duration.ofSeconds(5);
  private static final Duration NEXT_STEPS_AFTER = Duration.ofSeconds(1);

  /** Whether something changed since the robots were last planned together. */
  private boolean changed = true;

  /** Whether a robot gave up a part of its path that others wait for it to drive. */
  private boolean mustReplan;

  /** Whether that is because nobody gets on. */
  private boolean still;

  /** Whether only the next steps of robots are planned. */
  private boolean plannedAhead;

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

  /** Whether robots have paths, and none has got on for long. */
  boolean isStill() {
    return still;
  }

  /** Whether only the next steps of robots were planned, so that they are planned again soon. */
  boolean isPlannedAhead() {
    return plannedAhead;
  }

  /** Whether to plan now; counts as planned from now on. */
  boolean takePlanNeeded(
      Collection<TrafficRobot> robots, List<Standstill> standstills, Instant now) {
    boolean isCycle =
        standstills.stream().anyMatch(s -> s.kind() == Standstill.Kind.CYCLE_OF_WAITS);
    still = hasNoProgress(robots, now);
    mustReplan |= isCycle || still;
    boolean isNeeded =
        mustReplan
            || robots.stream()
                .anyMatch(robot -> robot.needsPath() || (plannedAhead && robot.isPlannedAhead()));
    boolean isDue =
        plannedAhead
            ? !now.isBefore(lastJointPlan.plus(NEXT_STEPS_AFTER))
            : changed || lastJointPlan.plus(PLAN_AGAIN_AFTER).isBefore(now);
    if (!isNeeded || !isDue) {
      return false;
    }
    lastJointPlan = now;
    changed = false;
    return true;
  }

  /**
   * All robots have paths by a new plan.
   *
   * @param ahead whether these are only the next steps
   */
  void recordPlanned(boolean ahead) {
    mustReplan = false;
    plannedAhead = ahead;
  }

  /** Whether robots have paths, and none has got on for long. */
  private boolean hasNoProgress(Collection<TrafficRobot> robots, Instant now) {
    return lastProgress.plus(NO_PROGRESS_AFTER).isBefore(now)
        && robots.stream().anyMatch(robot -> robot.drive.hasUnreleased())
        && robots.stream().noneMatch(robot -> robot.drive.isDriving() && !robot.isStalled());
  }
}
