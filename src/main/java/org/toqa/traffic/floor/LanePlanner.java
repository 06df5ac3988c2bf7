package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.JointPlanner;

/**
 * Plans robots together on lane cells and gives them their paths.
 *
 * <p>Tried in this order, until everybody who wants to go somewhere can: with wide lane cells, on
 * which robots of every size can be planned, then with narrower ones, those first that leave the
 * fewest out, for a while at least; first without those who drive paths of their own or are beside
 * the lanes, then with them. Who is left out is driven round. Of more than {@value #MOST_WHOLE}
 * robots only the next steps are planned ({@link NextStepsPlanner}), those included whose own paths
 * come near.
 */
final class LanePlanner {
  /** Of more robots only the next steps are planned. */
  static final int MOST_WHOLE = 8;

  /**
   * For so long robots whose next steps are planned stay on lanes of one width: else they could be
   * led from the middles of wide lane cells to those of narrow ones and back, and get nowhere.
   */
  private static final Duration SAME_WIDTH = Duration.ofSeconds(20);

  /** Of the time for a plan of all robots, what one of their next steps only may take. */
  private static final double SHARE_OF_STEPS = 0.5;

  private final FreeSpace freeSpace;
  private final SectionFitter fitter;
  private final JointPlanner planner;
  private final NextStepsPlanner nextSteps;
  private final RightOfWay rightOfWay;
  private final LaneTurns turns;
  private final Supplier<Deadline> planningDeadline;

  /** Of the robots for which the lanes were on which next steps were planned last, metres. */
  private double keptWidth;

  private Instant widthKeptSince = Instant.MIN;

  LanePlanner(
      FreeSpace freeSpace,
      SectionFitter fitter,
      JointPlanner planner,
      NextStepsPlanner nextSteps,
      RightOfWay rightOfWay,
      LaneTurns turns,
      Supplier<Deadline> planningDeadline) {
    this.freeSpace = freeSpace;
    this.fitter = fitter;
    this.planner = planner;
    this.nextSteps = nextSteps;
    this.rightOfWay = rightOfWay;
    this.turns = turns;
    this.planningDeadline = planningDeadline;
  }

  /**
   * @param claimed what the robots have or will need
   * @param mustPlan whether paths were given up that others wait for
   */
  LaneOutcome plan(
      Collection<TrafficRobot> robots,
      Claims claims,
      ClaimedAreas claimed,
      boolean mustPlan,
      boolean isStill,
      Instant now) {
    Deadline deadline = planningDeadline.get();
    Deadline deadlineOfSteps = deadline.afterShare(SHARE_OF_STEPS);
    rightOfWay.setPlanned(Set.of());
    turns.update(robots, now);
    List<LaneAttempt> incomplete = new ArrayList<>();
    int fewestLeftOut = Integer.MAX_VALUE;
    for (boolean everybody : List.of(false, true)) {
      for (LaneAttempt attempt : attempts(robots, claims, claimed, everybody, now)) {
        int leftOut = attempt.leftOutCount();
        if (everybody && !isStill && leftOut >= fewestLeftOut && fewestLeftOut > 0) {
          continue; // who is at its goal would be moved for nobody's sake
        }
        fewestLeftOut = Math.min(fewestLeftOut, leftOut);
        if (!isStill && attempt.robotCount() > (rightOfWay.isClosed() ? 0 : MOST_WHOLE)) {
          attempt.recordHolders();
          if (attempt.planAhead(nextSteps, now, deadlineOfSteps)) {
            keepWidth(attempt.diameter(), now);
            turns.end();
            return LaneOutcome.PLANNED_AHEAD;
          }
        }
        if (leftOut > 0) {
          incomplete.add(attempt);
        } else {
          LaneOutcome outcome = tryPlan(attempt, mustPlan, now, deadline);
          if (outcome != LaneOutcome.NOT_FOUND) {
            return outcome;
          }
        }
      }
    }
    incomplete.sort(Comparator.comparingInt(LaneAttempt::leftOutCount));
    for (LaneAttempt attempt : incomplete) {
      LaneOutcome outcome = tryPlan(attempt, mustPlan, now, deadline);
      if (outcome != LaneOutcome.NOT_FOUND) {
        return outcome;
      }
    }
    return LaneOutcome.NOT_FOUND;
  }

  /**
   * On lanes of each width, up to those that leave nobody out: those that are kept first, then
   * those that leave the fewest out.
   */
  private List<LaneAttempt> attempts(
      Collection<TrafficRobot> robots,
      Claims claims,
      ClaimedAreas claimed,
      boolean everybody,
      Instant now) {
    boolean isWidthKept = now.isBefore(widthKeptSince.plus(SAME_WIDTH));
    Comparator<Double> keptFirst = Comparator.comparing(d -> !(isWidthKept && d == keptWidth));
    List<LaneAttempt> attempts = new ArrayList<>();
    for (double diameter : diameters(robots, everybody).stream().sorted(keptFirst).toList()) {
      LaneAttempt attempt =
          new LaneAttempt(
              freeSpace, fitter, rightOfWay, robots, claims, claimed, diameter, everybody);
      attempts.add(attempt);
      if (attempt.leftOutCount() == 0) {
        break;
      }
    }
    attempts.sort(
        Comparator.comparing(LaneAttempt::diameter, keptFirst)
            .thenComparingInt(LaneAttempt::leftOutCount));
    return attempts;
  }

  private void keepWidth(double diameter, Instant now) {
    if (diameter != keptWidth) {
      keptWidth = diameter;
      widthKeptSince = now;
    }
  }

  private LaneOutcome tryPlan(
      LaneAttempt attempt, boolean mustPlan, Instant now, Deadline deadline) {
    attempt.recordHolders();
    if (!mustPlan && !attempt.isOfUse()) {
      return LaneOutcome.NOT_NEEDED;
    }
    return attempt.planWhole(planner, turns, now, deadline)
        ? LaneOutcome.PLANNED
        : LaneOutcome.NOT_FOUND;
  }

  /** Of the robots that need a plan, or of everybody; the largest first. */
  private Set<Double> diameters(Collection<TrafficRobot> robots, boolean everybody) {
    Set<Double> diameters = new TreeSet<>(Comparator.reverseOrder());
    for (TrafficRobot robot : robots) {
      boolean needsPlan = everybody || robot.needsPath() || robot.drive.isOnSharedPath();
      if (robot.isMovable()
          && robot.formation() == null
          && needsPlan
          && LaneGrid.hasRoom(freeSpace.grid(), 2 * robot.radius())) {
        diameters.add(2 * robot.radius());
      }
    }
    return diameters;
  }
}
