package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.Arrays;
import org.toqa.traffic.mapf.StateGraph;

/**
 * What each robot is going to do in the next steps, its operation, and who is where after each of
 * them. Robots are counted from 0.
 */
final class Operations {
  private final StateGraph graph;
  private final int depth;

  /** By robot: its states after 0, 1, 2 ... steps. */
  private int[][] operations = new int[0][];

  /** By step and vertex: the robot that is there then. */
  private final int[][] occupants;

  Operations(StateGraph graph, int depth) {
    this.graph = graph;
    this.depth = depth;
    this.occupants = new int[depth + 1][graph.roads().vertexCount()];
    for (int[] occupant : occupants) {
      Arrays.fill(occupant, NONE);
    }
  }

  /** Steps of an operation. */
  int depth() {
    return depth;
  }

  /** The robot's states; whoever changes them takes the robot off before, and puts it on after. */
  int[] of(int robot) {
    return operations[robot];
  }

  int state(int robot, int step) {
    return operations[robot][step];
  }

  int occupant(int step, int vertex) {
    return occupants[step][vertex];
  }

  void put(int robot) {
    int[] states = operations[robot];
    for (int t = 0; t <= depth; t++) {
      occupants[t][graph.vertex(states[t])] = robot;
    }
  }

  void take(int robot) {
    int[] states = operations[robot];
    for (int t = 0; t <= depth; t++) {
      occupants[t][graph.vertex(states[t])] = NONE;
    }
  }

  /**
   * Starts from other robots or other places. Who has done the first step of its operation keeps
   * the rest of it; who has not, waits where it is, and so does whoever meant to pass there.
   *
   * @param present the robots' states now; no two on a vertex
   * @param former what they meant to do one step ago, from then on; null for none
   */
  void restart(int[] present, int[][] former) {
    for (int robot = 0; robot < operations.length; robot++) {
      take(robot);
    }
    operations = new int[present.length][];
    int[] strays = new int[present.length];
    int count = 0;
    for (int robot = 0; robot < present.length; robot++) {
      int[] meant = former[robot];
      if (meant != null && meant[1] == present[robot]) {
        System.arraycopy(meant, 1, meant, 0, depth);
        operations[robot] = meant;
        put(robot);
      } else {
        operations[robot] = new int[depth + 1];
        Arrays.fill(operations[robot], present[robot]);
        strays[count++] = robot;
      }
    }
    while (count > 0) {
      int robot = strays[--count];
      int vertex = graph.vertex(present[robot]);
      for (int t = 0; t <= depth; t++) {
        int other = occupants[t][vertex];
        if (other != NONE) {
          take(other);
          Arrays.fill(operations[other], present[other]);
          strays[count++] = other;
        }
      }
      put(robot);
    }
  }

  /**
   * Whether the robot's operation closes a ring of robots that all go at once, each to where the
   * next one is just leaving.
   */
  boolean closesRing(int robot) {
    for (int t = 1; t <= depth; t++) {
      int ahead = robot;
      do {
        int vertex = graph.vertex(operations[ahead][t]);
        int next = occupants[t - 1][vertex];
        if (next == ahead) {
          break;
        }
        ahead = next;
      } while (ahead != NONE && ahead != robot);
      if (ahead == robot && graph.vertex(operations[robot][t]) != vertexBefore(robot, t)) {
        return true;
      }
    }
    return false;
  }

  private int vertexBefore(int robot, int step) {
    return graph.vertex(operations[robot][step - 1]);
  }
}
