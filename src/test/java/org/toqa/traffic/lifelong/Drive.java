package org.toqa.traffic.lifelong;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.check.TrafficChecker;

/** Robots on a floor that do what a planner says, every step looked at by the checker. */
final class Drive {
  private final LifelongPlanner planner;
  private final TrafficChecker checker;
  private RoadGraph roads;
  private final List<GridPose> stances;
  private final List<Cell> goals;
  private final BitSet fixed = new BitSet();

  Drive(
      OccupancyGrid grid,
      MotionModel model,
      LifelongPlanner planner,
      List<Cell> starts,
      List<Cell> goals) {
    this.planner = planner;
    this.checker = new TrafficChecker(grid, model);
    this.roads = new RoadGraph(grid);
    this.stances =
        new ArrayList<>(starts.stream().map(cell -> new GridPose(cell, Heading.EAST)).toList());
    this.goals = new ArrayList<>(goals);
  }

  GridPose stance(int robot) {
    return stances.get(robot);
  }

  void headFor(int robot, Cell goal) {
    goals.set(robot, goal);
  }

  /** Has a robot stay where it is from now on, or move again. */
  void fix(int robot, boolean isFixed) {
    fixed.set(robot, isFixed);
  }

  /** The cells that may be driven from now on. */
  void driveOn(OccupancyGrid grid) {
    roads = new RoadGraph(grid);
  }

  boolean isArrived(int robot) {
    return stances.get(robot).cell().equals(goals.get(robot));
  }

  boolean areAllArrived() {
    return IntStream.range(0, goals.size()).allMatch(this::isArrived);
  }

  LifelongPlan plan() {
    return plan(Deadline.none());
  }

  LifelongPlan plan(Deadline deadline) {
    TrafficSnapshot scene =
        new TrafficSnapshot(
            roads, IntStream.range(0, goals.size()).mapToObj(r -> robot(r)).toList());
    LifelongPlan plan = planner.plan(scene, deadline);
    assertHoldsTogether(plan);
    return plan;
  }

  private PlannedRobot robot(int r) {
    return new PlannedRobot("r" + r, stances.get(r), goals.get(r), 0, fixed.get(r));
  }

  /** Every step of the plan keeps the rules, not just the first. */
  private void assertHoldsTogether(LifelongPlan plan) {
    int horizon = plan.paths().stream().mapToInt(i -> i.poses().size()).max().orElse(1);
    for (int step = 0; step < horizon; step++) {
      assertEquals(List.of(), checker.check(at(plan, step), at(plan, step + 1)));
    }
    assertEquals(stances, at(plan, 0));
  }

  private static List<GridPose> at(LifelongPlan plan, int step) {
    return plan.paths().stream().map(path -> path.at(step)).toList();
  }

  /** One step of all robots. */
  LifelongPlan step() {
    LifelongPlan plan = plan();
    for (int robot = 0; robot < stances.size(); robot++) {
      obey(robot, plan);
    }
    return plan;
  }

  /** One step of one robot; the caller sees to it that it does not collide. */
  void obey(int robot, LifelongPlan plan) {
    stances.set(robot, plan.path(robot).at(1));
  }

  /** Drives until all have arrived, which has to be within so many steps. */
  Drive untilArrived(int steps) {
    for (int step = 0; step < steps && !areAllArrived(); step++) {
      step();
    }
    assertTrue(areAllArrived(), () -> "after " + steps + " steps: " + stances + " to " + goals);
    return this;
  }

  PlanStatus prospect(int robot) {
    return plan().path(robot).status();
  }
}
