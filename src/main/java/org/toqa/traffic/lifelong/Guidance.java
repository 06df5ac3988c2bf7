package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;
import static org.toqa.traffic.RoadGraph.opposite;

import java.util.Arrays;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.route.StateGraph;

/**
 * Distances that know of oncoming traffic, so that robots keep to the side on which others go their
 * way before they meet.
 *
 * <p>Idea: each robot announces the edges of its shortest way. An edge costs a step, and half a
 * step more for each robot that announced it the other way about. Who plans next therefore prefers
 * an aisle that is driven in its direction; one-way streets form by themselves, and dissolve when
 * the traffic changes. A robot keeps its distances until it has a new goal.
 *
 * <p>Cost: one Dijkstra search a goal, with a row of stacks as queue, as the costs are small whole
 * numbers; it ends a margin beyond the robot.
 *
 * <p>After Z. Chen et al., "Traffic flow optimisation for lifelong multi-agent path finding", AAAI
 * 2024.
 */
final class Guidance {
  /** What a step costs; finer than 1, so that traffic can cost less than a step. */
  static final int STEP = 4;

  private static final int ONCOMING = STEP / 2;
  private static final int MOST_ONCOMING = 8 * STEP;

  /** More than the cost of any edge, and a power of two. */
  private static final int STACKS = 64;

  /** How far beyond the robot distances are known, for when it is pushed aside. */
  private static final int MARGIN = 32 * STEP;

  private final StateGraph graph;

  /** By edge, which is {@code vertex * 4 + direction}: how many have announced it. */
  private final int[] announced;

  Guidance(StateGraph graph) {
    this.graph = graph;
    this.announced = new int[graph.roads().vertices() * DIRECTIONS];
  }

  /**
   * Costs to the goal by state; {@link DistanceTables#UNREACHABLE} where there is no way, and
   * beyond the margin. Any number of threads may call it while nobody announces.
   */
  char[] distances(int start, int goal) {
    char[] costs = new char[graph.states()];
    Arrays.fill(costs, (char) DistanceTables.UNREACHABLE);
    StackRow open = new StackRow(graph.states());
    for (int heading = 0; heading < graph.headings(); heading++) {
      int state = graph.state(goal, heading);
      costs[state] = 0;
      open.push(state, 0);
    }
    int last = DistanceTables.UNREACHABLE - STACKS;
    for (int cost = 0; cost <= last && open.size > 0; cost++) {
      for (int state = open.pop(cost); state != NONE; state = open.pop(cost)) {
        if (costs[state] == cost) {
          relax(state, cost, costs, open);
        }
      }
      if (costs[start] == cost) {
        last = Math.min(last, cost + MARGIN);
      }
    }
    return costs;
  }

  private void relax(int state, int cost, char[] costs, StackRow open) {
    for (int action = 1; action < graph.actions(); action++) {
      int from = graph.before(state, action);
      if (from == NONE) {
        continue;
      }
      int through = cost + cost(from, state, action);
      if (through < costs[from]) {
        costs[from] = (char) through;
        open.push(from, through);
      }
    }
  }

  private int cost(int from, int to, int action) {
    int direction = graph.direction(from, action);
    if (direction == NONE) {
      return STEP;
    }
    int oncoming = announced[graph.vertex(to) * DIRECTIONS + opposite(direction)];
    return STEP + Math.min(MOST_ONCOMING, ONCOMING * oncoming);
  }

  /** Announces the cheapest way from a state on; answers its edges, to withdraw them. */
  int[] announce(int start, char[] costs) {
    int[] edges = new int[16];
    int count = 0;
    int state = start;
    int action = bestAction(state, costs);
    while (action != StateGraph.WAIT) {
      int direction = graph.direction(state, action);
      if (direction != NONE) {
        if (count == edges.length) {
          edges = Arrays.copyOf(edges, 2 * count);
        }
        edges[count++] = graph.vertex(state) * DIRECTIONS + direction;
      }
      state = graph.after(state, action);
      action = bestAction(state, costs);
    }
    int[] way = Arrays.copyOf(edges, count);
    for (int edge : way) {
      announced[edge]++;
    }
    return way;
  }

  private int bestAction(int state, char[] costs) {
    int best = StateGraph.WAIT;
    int least = costs[state];
    for (int action = 1; action < graph.actions(); action++) {
      int next = graph.after(state, action);
      if (next != NONE && costs[next] < least) {
        least = costs[next];
        best = action;
      }
    }
    return best;
  }

  void withdraw(int[] way) {
    for (int edge : way) {
      announced[edge]--;
    }
  }

  /** A priority queue for keys that never lie further apart than there are stacks. */
  private static final class StackRow {
    private final int[] tops = new int[STACKS];
    private int[] states;
    private int[] below;
    private int used;
    private int free = NONE;
    private int size;

    StackRow(int capacity) {
      states = new int[capacity];
      below = new int[capacity];
      Arrays.fill(tops, NONE);
    }

    void push(int state, int key) {
      int entry = free;
      if (entry != NONE) {
        free = below[entry];
      } else {
        entry = used++;
        if (entry == states.length) {
          states = Arrays.copyOf(states, 2 * entry);
          below = Arrays.copyOf(below, 2 * entry);
        }
      }
      states[entry] = state;
      below[entry] = tops[key % STACKS];
      tops[key % STACKS] = entry;
      size++;
    }

    int pop(int key) {
      int entry = tops[key % STACKS];
      if (entry == NONE) {
        return NONE;
      }
      tops[key % STACKS] = below[entry];
      below[entry] = free;
      free = entry;
      size--;
      return states[entry];
    }
  }
}
