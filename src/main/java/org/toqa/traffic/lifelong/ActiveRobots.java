package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import org.toqa.grid.Cell;
import org.toqa.planning.Heading;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.mapf.StateGraph;

/**
 * The robots of a snapshot that can take part in the traffic, counted from 0, as states and
 * vertices; and of every robot what it may expect.
 */
final class ActiveRobots {
  private final TrafficSnapshot snapshot;
  private final StateGraph graph;
  private final PlanStatus[] statuses;
  private final int[] robots;
  private final int[] states;
  private final int[] goals;
  private int size;

  private ActiveRobots(TrafficSnapshot snapshot, StateGraph graph) {
    this.snapshot = snapshot;
    this.graph = graph;
    int most = snapshot.robots().size();
    statuses = new PlanStatus[most];
    robots = new int[most];
    states = new int[most];
    goals = new int[most];
  }

  static ActiveRobots of(TrafficSnapshot snapshot, StateGraph graph) {
    ActiveRobots active = new ActiveRobots(snapshot, graph);
    boolean[] isTaken = new boolean[graph.roads().vertexCount()];
    for (int robot = 0; robot < snapshot.robots().size(); robot++) {
      active.add(robot, isTaken);
    }
    return active;
  }

  private void add(int robot, boolean[] isTaken) {
    RoadGraph roads = graph.roads();
    PlannedRobot asked = snapshot.robots().get(robot);
    int start = roads.vertex(asked.pose().cell());
    if (start == NONE || isTaken[start]) {
      statuses[robot] = start == NONE ? PlanStatus.START_BLOCKED : PlanStatus.START_SHARED;
      return;
    }
    isTaken[start] = true;
    int goal = roads.vertex(asked.goal());
    statuses[robot] = asked.isFixed() && start != goal ? PlanStatus.FIXED : status(start, goal);
    robots[size] = robot;
    states[size] = graph.state(start, direction(asked.pose().heading()));
    goals[size] = goal != NONE && roads.canReach(start, goal) ? goal : NONE;
    size++;
  }

  private PlanStatus status(int start, int goal) {
    if (goal == NONE) {
      return PlanStatus.GOAL_BLOCKED;
    }
    if (!graph.roads().canReach(start, goal)) {
      return PlanStatus.NO_PATH;
    }
    return start == goal ? PlanStatus.ARRIVED : PlanStatus.DRIVING;
  }

  /** How many take part. */
  int size() {
    return size;
  }

  /** The index in the snapshot of the k-th that takes part. */
  int robot(int k) {
    return robots[k];
  }

  int state(int k) {
    return states[k];
  }

  boolean isFixed(int k) {
    return snapshot.robots().get(robots[k]).isFixed();
  }

  /** The steps until it is where its state says. */
  int delay(int k) {
    return snapshot.robots().get(robots[k]).delay();
  }

  /** A vertex that it can reach, or {@code NONE}. */
  int goal(int k) {
    return goals[k];
  }

  /** Says where the k-th robot is after {@code step} steps, from 1 on, as a state. */
  @FunctionalInterface
  interface PlannedStates {
    int state(int k, int step);
  }

  /**
   * The plan in which each that takes part goes on as planned, and all others stay.
   *
   * @param horizon steps
   * @param isPlanned whether there is a path for the k-th
   */
  LifelongPlan toPlan(int horizon, PlannedStates states, IntPredicate isPlanned) {
    PlannedPath[] paths = new PlannedPath[statuses.length];
    for (int robot = 0; robot < paths.length; robot++) {
      paths[robot] = new PlannedPath(List.of(snapshot.robots().get(robot).pose()), statuses[robot]);
    }
    for (int k = 0; k < size; k++) {
      int robot = robots[k];
      List<GridPose> poses = new ArrayList<>();
      poses.add(snapshot.robots().get(robot).pose());
      for (int step = 1; step <= horizon; step++) {
        poses.add(pose(robot, states.state(k, step)));
      }
      PlanStatus status = isPlanned.test(k) ? statuses[robot] : PlanStatus.NOT_YET_PLANNED;
      paths[robot] = new PlannedPath(poses, status);
    }
    return new LifelongPlan(List.of(paths));
  }

  /** A state as a pose of that robot; its heading stays where the model knows none. */
  private GridPose pose(int robot, int state) {
    Cell cell = graph.roads().cell(graph.vertex(state));
    return graph.model() == MotionModel.CLASSIC
        ? new GridPose(cell, snapshot.robots().get(robot).pose().heading())
        : new GridPose(cell, heading(graph.heading(state)));
  }

  /** Four directions to the right angles of eight headings; both count from east to the left. */
  private static Heading heading(int direction) {
    return Heading.EAST.turned(2 * direction);
  }

  /** The direction faced, or the next one to the left of a diagonal. */
  private static int direction(Heading heading) {
    return (heading.ordinal() + 1) / 2 % RoadGraph.DIRECTIONS;
  }
}
