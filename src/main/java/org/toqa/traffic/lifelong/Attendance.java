package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import org.toqa.grid.Cell;
import org.toqa.planning.Heading;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.Prospect;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Stance;
import org.toqa.traffic.TrafficRobot;
import org.toqa.traffic.TrafficScene;
import org.toqa.traffic.route.StateGraph;

/**
 * The robots of a scene that can take part in the traffic, counted from 0, as states and vertices;
 * and of every robot what it may expect.
 */
final class Attendance {
  private final TrafficScene scene;
  private final StateGraph graph;
  private final Prospect[] prospects;
  private final int[] robots;
  private final int[] states;
  private final int[] goals;
  private int size;

  private Attendance(TrafficScene scene, StateGraph graph) {
    this.scene = scene;
    this.graph = graph;
    int most = scene.robots().size();
    prospects = new Prospect[most];
    robots = new int[most];
    states = new int[most];
    goals = new int[most];
  }

  static Attendance of(TrafficScene scene, StateGraph graph) {
    Attendance attendance = new Attendance(scene, graph);
    boolean[] isTaken = new boolean[graph.roads().vertices()];
    for (int robot = 0; robot < scene.robots().size(); robot++) {
      attendance.take(robot, isTaken);
    }
    return attendance;
  }

  private void take(int robot, boolean[] isTaken) {
    RoadGraph roads = graph.roads();
    TrafficRobot asked = scene.robots().get(robot);
    int start = roads.vertex(asked.stance().cell());
    if (start == NONE || isTaken[start]) {
      prospects[robot] = start == NONE ? Prospect.START_BLOCKED : Prospect.START_SHARED;
      return;
    }
    isTaken[start] = true;
    int goal = roads.vertex(asked.goal());
    prospects[robot] = prospect(start, goal);
    robots[size] = robot;
    states[size] = graph.state(start, direction(asked.stance().heading()));
    goals[size] = goal != NONE && roads.isConnected(start, goal) ? goal : NONE;
    size++;
  }

  private Prospect prospect(int start, int goal) {
    if (goal == NONE) {
      return Prospect.GOAL_BLOCKED;
    }
    if (!graph.roads().isConnected(start, goal)) {
      return Prospect.NO_WAY;
    }
    return start == goal ? Prospect.ARRIVED : Prospect.ON_ITS_WAY;
  }

  /** How many take part. */
  int size() {
    return size;
  }

  /** The place in the scene of the k-th that takes part. */
  int robot(int k) {
    return robots[k];
  }

  int state(int k) {
    return states[k];
  }

  /** A vertex that it can reach, or {@code NONE}. */
  int goal(int k) {
    return goals[k];
  }

  /**
   * @param robot by its place in the scene
   */
  Prospect prospect(int robot) {
    return prospects[robot];
  }

  /** A state as a stance of that robot; its heading stays where the model knows none. */
  Stance stance(int robot, int state) {
    Cell cell = graph.roads().cell(graph.vertex(state));
    return graph.model() == MotionModel.CLASSIC
        ? new Stance(cell, scene.robots().get(robot).stance().heading())
        : new Stance(cell, heading(graph.heading(state)));
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
