package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.Arrays;
import java.util.BitSet;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;
import org.toqa.traffic.mapf.StateGraph;

/**
 * What each robot is going to do in the next steps, its operation, and who is where after each of
 * them. Robots are counted from 0.
 */
final class Operations {
  /** More than one robot. */
  static final int SEVERAL = -2;

  private final StateGraph graph;
  private final Spacing spacing;
  private final boolean hasNoSpacing;
  private final int depth;

  /** By robot: its states after 0, 1, 2 ... steps. */
  private int[][] operations = new int[0][];

  /** By step and vertex: the robot that is there then. */
  private final int[][] occupants;

  /** The edges that nobody may drive now. */
  private BitSet closed = new BitSet();

  /** By robot: the search for a ring in which it was last met, so that nothing is cleared. */
  private int[] met = new int[0];

  private int searches;

  /**
   * @param spacing which vertices cannot be taken at once
   */
  Operations(StateGraph graph, Spacing spacing, int depth) {
    this.graph = graph;
    this.spacing = spacing;
    this.hasNoSpacing = spacing.isNone();
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

  /** Whether nobody may go from a vertex in a direction now. */
  boolean isClosed(int vertex, int direction) {
    return closed.get(vertex * RoadGraph.DIRECTIONS + direction);
  }

  /**
   * Who is in the way of a robot that is taken off, if it goes to a vertex, or stays there, in its
   * step after {@code t}.
   *
   * @param direction in which it goes, {@code NONE} if it stays
   * @return {@code NONE}, a robot, or {@link #SEVERAL}
   */
  int inWay(int from, int to, int direction, int t) {
    int robot = occupants[t + 1][to];
    if (hasNoSpacing) {
      int other = direction == NONE ? NONE : occupants[t][to];
      return other != NONE && vertexAt(other, t + 1) == from ? with(robot, other) : robot;
    }
    for (int vertex : spacing.near(to)) {
      int other = occupants[t + 1][vertex];
      if (other != NONE && !spacing.mayBeAt(to, vertex, from, vertexAt(other, t))) {
        robot = with(robot, other);
      }
    }
    if (direction != NONE) {
      for (int edge : spacing.opposite(from, direction)) {
        int start = edge / RoadGraph.DIRECTIONS;
        int other = occupants[t][start];
        if (other != NONE
            && vertexAt(other, t + 1)
                == graph.roads().neighbour(start, edge % RoadGraph.DIRECTIONS)) {
          robot = with(robot, other);
        }
      }
    }
    return robot;
  }

  private static int with(int robot, int other) {
    return robot == NONE || robot == other ? other : SEVERAL;
  }

  /**
   * Starts from other robots or other places. Who is where its operation would have it goes on with
   * that, as late as it and those are that were to go before it ({@link DelayedOperations}); who is
   * not, or is in the way of others now, waits where it is, and so does whoever meant to pass
   * there.
   *
   * @param present the robots' states now; no two on a vertex
   * @param former what they meant to do, from then on; null for none
   * @param steps that have passed since then
   * @param delays the steps until the robots are where their states say: they wait so long there
   * @param closedNow the edges that nobody may drive now
   */
  void restart(int[] present, int[][] former, int steps, int[] delays, BitSet closedNow) {
    for (int robot = 0; robot < operations.length; robot++) {
      take(robot);
    }
    closed = closedNow;
    operations =
        new DelayedOperations(graph, spacing, depth, closedNow, present, former, steps, delays)
            .operations();
    met = new int[present.length];
    searches = 0;
    int[] strays = new int[present.length];
    int count = 0;
    for (int robot = 0; robot < present.length; robot++) {
      boolean isStanding = former[robot] == null;
      if (!isStanding && isPossible(robot)) {
        put(robot);
      } else {
        strays[count++] = robot;
      }
    }
    for (int k = 0; k < count; k++) {
      Arrays.fill(operations[strays[k]], present[strays[k]]);
    }
    while (count > 0) {
      int robot = strays[--count];
      int vertex = graph.vertex(present[robot]);
      for (int t = 0; t < depth; t++) {
        count = stop(occupants[t][vertex], strays, count);
        for (int near : spacing.near(vertex)) {
          int other = occupants[t + 1][near];
          if (other != NONE && !spacing.mayBeAt(vertex, near, vertex, vertexAt(other, t))) {
            count = stop(other, strays, count);
          }
        }
      }
      count = stop(occupants[depth][vertex], strays, count);
      put(robot);
    }
  }

  /** Makes a robot that is met at a step wait where it is; it is a stray from now on. */
  private int stop(int robot, int[] strays, int count) {
    if (robot == NONE) {
      return count;
    }
    take(robot);
    Arrays.fill(operations[robot], operations[robot][0]);
    strays[count] = robot;
    return count + 1;
  }

  /** Whether nobody who is put on, and no closed edge, is in the way of a robot's operation. */
  private boolean isPossible(int robot) {
    for (int t = 0; t < depth; t++) {
      int from = vertexAt(robot, t);
      int to = vertexAt(robot, t + 1);
      int direction = from == to ? NONE : graph.roads().direction(from, to);
      if ((direction != NONE && isClosed(from, direction))
          || inWay(from, to, direction, t) != NONE) {
        return false;
      }
    }
    put(robot);
    boolean isRing = closesRing(robot);
    take(robot);
    return !isRing;
  }

  /**
   * Whether the robot's operation closes a ring of robots that all go at once, each to where the
   * next one is just leaving, or too near to that.
   */
  boolean closesRing(int robot) {
    for (int t = 1; t <= depth; t++) {
      if (vertexAt(robot, t) != vertexAt(robot, t - 1)) {
        searches++;
        if (leadsTo(robot, robot, t)) {
          return true;
        }
      }
    }
    return false;
  }

  private boolean leadsTo(int robot, int wanted, int t) {
    int to = vertexAt(robot, t);
    if (waitsFor(occupants[t - 1][to], robot, wanted, t)) {
      return true;
    }
    for (int vertex : spacing.near(to)) {
      int other = occupants[t - 1][vertex];
      if (other != NONE
          && !spacing.mayBeAt(to, vertex, vertexAt(robot, t - 1), vertex)
          && waitsFor(other, robot, wanted, t)) {
        return true;
      }
    }
    return false;
  }

  /** Whether one that a robot would drive into goes on, and waits, over others, for the wanted. */
  private boolean waitsFor(int other, int robot, int wanted, int t) {
    if (other == NONE || other == robot || vertexAt(other, t) == vertexAt(other, t - 1)) {
      return false;
    }
    if (other == wanted) {
      return true;
    }
    if (met[other] == searches) {
      return false;
    }
    met[other] = searches;
    return leadsTo(other, wanted, t);
  }

  private int vertexAt(int robot, int step) {
    return graph.vertex(operations[robot][step]);
  }
}
