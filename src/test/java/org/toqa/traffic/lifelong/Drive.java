package org.toqa.traffic.lifelong;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.Prospect;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Stance;
import org.toqa.traffic.TrafficChecker;
import org.toqa.traffic.TrafficPlan;
import org.toqa.traffic.TrafficPlanner;
import org.toqa.traffic.TrafficRobot;
import org.toqa.traffic.TrafficScene;

/** Robots on a floor that do what a planner says, every step looked at by the checker. */
final class Drive {
  private final TrafficPlanner planner;
  private final TrafficChecker checker;
  private RoadGraph roads;
  private final List<Stance> stances;
  private final List<Cell> goals;

  Drive(
      OccupancyGrid grid,
      MotionModel model,
      TrafficPlanner planner,
      List<Cell> starts,
      List<Cell> goals) {
    this.planner = planner;
    this.checker = new TrafficChecker(grid, model);
    this.roads = new RoadGraph(grid);
    this.stances =
        new ArrayList<>(starts.stream().map(cell -> new Stance(cell, Heading.EAST)).toList());
    this.goals = new ArrayList<>(goals);
  }

  Stance stance(int robot) {
    return stances.get(robot);
  }

  void headFor(int robot, Cell goal) {
    goals.set(robot, goal);
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

  TrafficPlan plan() {
    return plan(Deadline.none());
  }

  TrafficPlan plan(Deadline deadline) {
    TrafficScene scene =
        new TrafficScene(
            roads,
            IntStream.range(0, goals.size())
                .mapToObj(r -> new TrafficRobot("r" + r, stances.get(r), goals.get(r), 0))
                .toList());
    TrafficPlan plan = planner.plan(scene, deadline);
    assertHoldsTogether(plan);
    return plan;
  }

  /** Every step of the plan keeps the rules, not just the first. */
  private void assertHoldsTogether(TrafficPlan plan) {
    int horizon = plan.itineraries().stream().mapToInt(i -> i.stances().size()).max().orElse(1);
    for (int step = 0; step < horizon; step++) {
      assertEquals(List.of(), checker.check(at(plan, step), at(plan, step + 1)));
    }
    assertEquals(stances, at(plan, 0));
  }

  private static List<Stance> at(TrafficPlan plan, int step) {
    return plan.itineraries().stream().map(itinerary -> itinerary.at(step)).toList();
  }

  /** One step of all robots. */
  TrafficPlan step() {
    TrafficPlan plan = plan();
    for (int robot = 0; robot < stances.size(); robot++) {
      obey(robot, plan);
    }
    return plan;
  }

  /** One step of one robot; the caller sees to it that it does not collide. */
  void obey(int robot, TrafficPlan plan) {
    stances.set(robot, plan.of(robot).at(1));
  }

  /** Drives until all have arrived, which has to be within so many steps. */
  Drive untilArrived(int steps) {
    for (int step = 0; step < steps && !areAllArrived(); step++) {
      step();
    }
    assertTrue(areAllArrived(), () -> "after " + steps + " steps: " + stances + " to " + goals);
    return this;
  }

  Prospect prospect(int robot) {
    return plan().of(robot).prospect();
  }
}
