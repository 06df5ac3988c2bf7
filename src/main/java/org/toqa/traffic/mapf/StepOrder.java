package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.Arrays;
import java.util.List;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * Who has to leave before whom in one step. On a floor robots do not move at once: one that goes to
 * a place waits until whoever is there, or too near to it, has left. A step can be driven where
 * these waits have no cycle.
 */
final class StepOrder {
  private final Spacing spacing;
  private final int[] from;
  private final int[] to;

  /** Who is on a vertex before the step. */
  private final int[] before;

  /** By robot: the search in which it was last met, so that nothing is cleared. */
  private final int[] met;

  private int searches;

  /**
   * @param from where each robot is, {@link RoadGraph#NONE} for none; read at each call
   * @param to where each goes, {@link RoadGraph#NONE} where that is open; read at each call
   * @param before who is on a vertex; read at each call
   */
  StepOrder(Spacing spacing, int[] from, int[] to, int[] before) {
    this.spacing = spacing;
    this.from = from;
    this.to = to;
    this.before = before;
    this.met = new int[from.length];
  }

  /** Whether a robot that moves waits, over others, for itself. */
  boolean isInCycle(int robot) {
    if (to[robot] == from[robot]) {
      return false;
    }
    searches++;
    return leadsTo(robot, robot);
  }

  private boolean leadsTo(int robot, int wanted) {
    if (waitsFor(robot, before[to[robot]], wanted)) {
      return true;
    }
    for (int vertex : spacing.near(to[robot])) {
      if (waitsFor(robot, before[vertex], wanted)) {
        return true;
      }
    }
    return false;
  }

  /** Whether a robot waits for that one to leave, and it for the wanted one. */
  private boolean waitsFor(int robot, int other, int wanted) {
    if (other == NONE
        || other == robot
        || to[other] == NONE
        || to[other] == from[other]
        || spacing.mayBeAt(to[robot], from[other], from[robot], from[other])) {
      return false;
    }
    if (other == wanted) {
      return true;
    }
    if (met[other] == searches) {
      return false;
    }
    met[other] = searches;
    return leadsTo(other, wanted);
  }

  /** Whether some step of a plan cannot be driven, as robots would wait for each other. */
  static boolean hasCycle(RoadGraph roads, Spacing spacing, List<int[]> configurations) {
    int robots = configurations.getFirst().length;
    int[] from = new int[robots];
    int[] to = new int[robots];
    int[] before = new int[roads.vertexCount()];
    Arrays.fill(before, NONE);
    StepOrder order = new StepOrder(spacing, from, to, before);
    for (int step = 1; step < configurations.size(); step++) {
      System.arraycopy(configurations.get(step - 1), 0, from, 0, robots);
      System.arraycopy(configurations.get(step), 0, to, 0, robots);
      for (int robot = 0; robot < robots; robot++) {
        before[from[robot]] = robot;
      }
      for (int robot = 0; robot < robots; robot++) {
        if (order.isInCycle(robot)) {
          return true;
        }
      }
      for (int vertex : from) {
        before[vertex] = NONE;
      }
    }
    return false;
  }
}
