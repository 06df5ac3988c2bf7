package org.toqa.traffic.floor;

import static java.util.Comparator.nullsLast;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.Margins;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.JointPlanner;
import org.toqa.traffic.lifelong.LifelongPlanner;

/**
 * Plans paths on a picture of the floor: first each robot's own, then all together where that
 * helps; and for those without one the reason, and room by others that step aside.
 *
 * <p>It changes nothing but copies of its own; what comes out is a value. One thread at a time may
 * ask it: it keeps what it knows of the floor and of who has waited from plan to plan.
 */
final class FloorPlanner {
  static final Duration RETRY_AFTER = Duration.ofSeconds(1);

  /** Of the time for a plan of all robots, what looking for robots' own paths may take. */
  private static final double SHARE_OF_SINGLE_ROBOTS = 0.25;

  /** Of the time for a plan of all robots, what finding out why some have none may take. */
  private static final double SHARE_OF_REASONS = 0.25;

  private final FreeSpace freeSpace;
  private final SingleRobotPlanner singleRobotPlanner;
  private final LanePlanner lanePlanner;
  private final RightOfWay rightOfWay;
  private final WaitReasonFinder waitReasons;
  private final RoomMaker roomMaker;
  private final Supplier<Deadline> planningDeadline;

  /**
   * @param moves by which robots drive alone
   * @param nextSteps planners of the next steps of robots that keep apart so many cells
   * @param planningDeadline by when a plan for all robots that begins now is to be ready
   */
  FloorPlanner(
      OccupancyGrid grid,
      Margins margins,
      Moves moves,
      JointPlanner jointPlanner,
      DoubleFunction<LifelongPlanner> nextSteps,
      Supplier<Deadline> planningDeadline) {
    SectionFitter fitter = new SectionFitter();
    this.freeSpace = new FreeSpace(grid, margins);
    this.singleRobotPlanner = new SingleRobotPlanner(freeSpace, fitter, moves);
    this.rightOfWay = new RightOfWay(singleRobotPlanner);
    LaneTurns turns = new LaneTurns();
    this.lanePlanner =
        new LanePlanner(
            freeSpace,
            fitter,
            jointPlanner,
            new NextStepsPlanner(nextSteps),
            rightOfWay,
            turns,
            planningDeadline);
    this.waitReasons = new WaitReasonFinder(freeSpace, singleRobotPlanner, rightOfWay, turns);
    this.roomMaker = new RoomMaker(singleRobotPlanner);
    this.planningDeadline = planningDeadline;
  }

  FloorPlan plan(PlanningRequest request) {
    Map<String, TrafficRobot> robots = new RobotMap<>();
    request.robots().forEach(pictured -> robots.put(pictured.name, pictured.copy()));
    freeSpace.setObstacles(request.obstacles());
    singleRobotPlanner.begin();
    singleRobotPlanner.keepFormations(robots.values());
    rightOfWay.update(robots.values(), request.now());
    rightOfWay.freePathsOver(robots.values());
    ClaimedAreas claimed = new ClaimedAreas(robots.values());
    planSingleRobots(request, robots.values(), claimed);
    LaneOutcome outcome = planJointly(request, robots.values(), claimed);
    findWaitReasons(robots.values(), claimed, request.now());
    robots.values().stream()
        .filter(TrafficRobot::needsPath)
        .forEach(robot -> roomMaker.makeRoomFor(robot, robots, claimed, request.now()));
    return result(request, robots, outcome);
  }

  /**
   * Gives their own paths to those that wait: whose way is closed to others, then formations, then
   * the longest waiting.
   */
  private void planSingleRobots(
      PlanningRequest request, Collection<TrafficRobot> robots, ClaimedAreas claimed) {
    List<TrafficRobot> due =
        robots.stream()
            .filter(robot -> request.dueForOwnPath().contains(robot.name))
            .sorted(
                Comparator.<TrafficRobot, Boolean>comparing(
                        robot -> !robot.name.equals(rightOfWay.holder()))
                    .thenComparing(robot -> !robot.isFormation())
                    .thenComparing(
                        robot -> robot.waiting.since(),
                        nullsLast(Comparator.<Instant>naturalOrder())))
            .toList();
    Deadline end = planningDeadline.get().afterShare(SHARE_OF_SINGLE_ROBOTS);
    for (int i = 0; i < due.size(); i++) {
      if (i > 0 && end.isPassed()) {
        due.get(i).waiting.leaveSinglePlan(); // for the next plan
      } else {
        planSingleRobot(due.get(i), robots, claimed, request.now());
      }
    }
  }

  private void planSingleRobot(
      TrafficRobot robot, Collection<TrafficRobot> robots, ClaimedAreas claimedAreas, Instant now) {
    List<SweptArea> claimed = claimedAreas.ofOthers(robot);
    if (!robot.name.equals(rightOfWay.holder())) {
      claimed.addAll(rightOfWay.closedTo(robot));
      robots.stream()
          .filter(other -> other.hasPrecedenceOver(robot))
          .forEach(other -> claimed.addAll(other.waiting.wanted()));
    }
    singleRobotPlanner
        .pathNow(robot, claimed, now)
        .ifPresent(
            sections -> {
              robot.continueOn(ReservedPath.independent(robot.committedEnd(), sections));
              robot.waiting.restart(null);
            });
  }

  private @Nullable LaneOutcome planJointly(
      PlanningRequest request, Collection<TrafficRobot> robots, ClaimedAreas claimed) {
    ReplanTrigger.Need need = request.need();
    if (!need.isDue() || !need.isOf(robots)) {
      return null;
    }
    Claims claims = new Claims(robots);
    claims.refresh();
    LaneOutcome outcome =
        lanePlanner.plan(robots, claims, claimed, need.mustReplan(), need.isStill(), request.now());
    if (outcome == LaneOutcome.PLANNED || outcome == LaneOutcome.PLANNED_AHEAD) {
      robots.stream()
          .filter(TrafficRobot::hasPathToGoal)
          .forEach(robot -> robot.waiting.endWaitForPath());
    }
    return outcome;
  }

  private void findWaitReasons(Collection<TrafficRobot> robots, ClaimedAreas claimed, Instant now) {
    List<TrafficRobot> due = new ArrayList<>();
    for (TrafficRobot robot : robots) {
      if (!robot.needsPath()) {
        robot.waiting.clearNoPathReason();
      } else if (robot.waiting.isNoPathReasonOlderThan(RETRY_AFTER, now)) {
        due.add(robot);
      }
    }
    due.sort(Comparator.comparing(robot -> robot.waiting.noPathReasonFound()));
    Deadline end = planningDeadline.get().afterShare(SHARE_OF_REASONS);
    for (TrafficRobot robot : due) {
      robot.waiting.setNoPathReason(waitReasons.reasonFor(robot, robots, claimed), now);
      if (end.isPassed()) {
        return; // the others, who were told later, in the next plan
      }
    }
  }

  private static FloorPlan result(
      PlanningRequest request, Map<String, TrafficRobot> robots, @Nullable LaneOutcome outcome) {
    List<ProposedPath> paths = new ArrayList<>();
    Map<String, WaitState.Findings> findings = new HashMap<>();
    for (TrafficRobot pictured : request.robots()) {
      TrafficRobot robot = Objects.requireNonNull(robots.get(pictured.name));
      findings.put(robot.name, robot.waiting.findings());
      if (robot.drive.pathNumber() != pictured.drive.pathNumber()) {
        paths.add(ProposedPath.of(pictured, robot));
      }
    }
    return new FloorPlan(request, paths, outcome, findings);
  }
}
