package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Says when the robots of a floor have to be planned together again. */
final class ReplanTrigger {
  private static final Duration NO_PROGRESS_AFTER = Duration.ofSeconds(10);
  private static final Duration PLAN_AGAIN_AFTER = Duration.ofSeconds(5);
  private static final Duration NEXT_STEPS_AFTER = Duration.ofSeconds(1);

  /** What no longer fitted of a plan when it was ready is planned again then. */
  private static final Duration REST_AFTER = Duration.ofMillis(300);

  /** Whether something changed since the robots were last planned together. */
  private boolean changed = true;

  /** Whether a robot gave up a part of its path that others wait for it to drive. */
  private boolean mustReplan;

  /** Whether only the next steps of robots are planned. */
  private boolean plannedAhead;

  /** Whether a part of the last plan no longer fitted when it was ready. */
  private boolean isInPart;

  /** When any robot last completed a section; null: it was not asked for yet. */
  private @Nullable Instant lastProgress;

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

  /** Whether only the next steps of robots were planned, so that they are planned again soon. */
  boolean isPlannedAhead() {
    return plannedAhead;
  }

  /**
   * Whether robots are to be planned together.
   *
   * @param isDue whether it is time for that
   * @param mustReplan whether paths were given up that others wait for, or nobody gets on
   * @param isStill whether robots have paths, and none has got on for long
   * @param wasChanged whether anything changed since they were last planned together
   * @param wasPlannedAhead whether only their next steps were planned
   */
  record Need(
      boolean isDue,
      boolean mustReplan,
      boolean isStill,
      boolean wasChanged,
      boolean wasPlannedAhead) {

    /** Whether it would help any of the robots. */
    boolean isOf(Collection<TrafficRobot> robots) {
      return mustReplan
          || robots.stream()
              .anyMatch(robot -> robot.needsPath() || (wasPlannedAhead && robot.isPlannedAhead()));
    }
  }

  Need need(Collection<TrafficRobot> robots, List<Standstill> standstills, Instant now) {
    boolean isCycle =
        standstills.stream().anyMatch(s -> s.kind() == Standstill.Kind.CYCLE_OF_WAITS);
    lastProgress = lastProgress == null ? now : lastProgress;
    boolean isStill = hasNoProgress(lastProgress, robots, now);
    boolean isDue =
        isInPart
            ? !now.isBefore(lastJointPlan.plus(REST_AFTER))
            : plannedAhead
                ? !now.isBefore(lastJointPlan.plus(NEXT_STEPS_AFTER))
                : changed || lastJointPlan.plus(PLAN_AGAIN_AFTER).isBefore(now);
    return new Need(isDue, mustReplan || isCycle || isStill, isStill, changed, plannedAhead);
  }

  /** What is needed now is being planned: what comes up from now on is not. */
  void recordRequest() {
    changed = false;
    mustReplan = false;
  }

  /**
   * A plan was made and adopted.
   *
   * @param isWhole whether all of it still fitted
   */
  void recordPlan(FloorPlan plan, boolean isWhole) {
    Need need = plan.request().need();
    if (plan.jointOutcome() == null) {
      changed |= need.wasChanged();
    } else {
      lastJointPlan = plan.request().now();
      isInPart = plan.isJoint() && !isWhole;
    }
    if (plan.isJoint()) {
      plannedAhead = plan.isPlannedAhead();
      mustReplan |= !isWhole;
    } else {
      mustReplan |= need.mustReplan();
    }
    changed |= !isWhole;
  }

  /** No plan was made, though one was asked for. */
  void recordFailure(PlanningRequest request) {
    changed |= request.need().wasChanged();
    mustReplan |= request.need().mustReplan();
  }

  /** Whether robots have paths, and none has got on for long. */
  private static boolean hasNoProgress(
      Instant lastProgress, Collection<TrafficRobot> robots, Instant now) {
    return lastProgress.plus(NO_PROGRESS_AFTER).isBefore(now)
        && robots.stream().anyMatch(robot -> robot.drive.hasUnreleased())
        && robots.stream().noneMatch(robot -> robot.drive.isDriving() && !robot.isStalled());
  }
}
