package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.NONE;
import static org.toqa.traffic.RoadGraph.opposite;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The quickest path of one robot among the paths of the others.
 *
 * <p>Idea: A* over (state, interval in which its vertex stays free) instead of (state, time): of
 * all arrivals in an interval only the earliest counts, since one can wait. The estimate is the
 * exact distance without others; whole numbers as keys make the queue a row of stacks.
 *
 * <p>M. Phillips and M. Likhachev, "SIPP: Safe interval path planning for dynamic environments",
 * ICRA 2011.
 */
public final class SafeIntervalSearch {
  private static final int FIRST_SIZE = 1024;

  private final StateGraph graph;
  private final ReservationTable reservations;

  /** The arrivals found so far, in the order in which they were found. */
  private int[] states = new int[FIRST_SIZE];

  private int[] times = new int[FIRST_SIZE];
  private int[] parents = new int[FIRST_SIZE];
  private int[] below = new int[FIRST_SIZE];
  private int count;
  private long effort;

  /** The top of the stack of each key; the key is arrival plus distance to go. */
  private final int[] tops;

  /** Bit by state and start of a free interval: its earliest arrival is known. */
  private final long[] closed;

  private final int words;

  public SafeIntervalSearch(StateGraph graph, ReservationTable reservations) {
    this.graph = graph;
    this.reservations = reservations;
    this.words = reservations.end() / Long.SIZE;
    this.closed = new long[graph.stateCount() * words];
    this.tops = new int[reservations.end() + 1];
    Arrays.fill(tops, NONE);
  }

  /**
   * @param start a state
   * @param goal a vertex, reached in any heading
   * @param distances steps from each state to the goal
   * @param latest when it has to have arrived
   * @return the states at the times 0, 1, 2 ... up to the arrival, from where on the goal stays
   *     free for ever; null where there is no such path
   */
  public int @Nullable [] path(int start, int goal, char[] distances, int latest) {
    int bound = Math.min(latest, reservations.end() - 1);
    int nearest = distances[start];
    count = 0;
    if (!reservations.isTaken(graph.vertex(start), 0)) {
      push(start, 0, NONE, nearest, bound);
    }
    int found = NONE;
    for (int key = nearest; key <= bound && found == NONE; key++) {
      while (tops[key] != NONE && found == NONE) {
        int arrival = tops[key];
        tops[key] = below[arrival];
        found = expand(arrival, goal, distances, bound);
      }
    }
    int[] path = found == NONE ? null : trace(found);
    clear(nearest, bound);
    effort += count;
    return path;
  }

  /** Arrivals looked at in all searches so far: a measure of work that needs no clock. */
  public long effort() {
    return effort;
  }

  /** Answers the arrival itself where it is at the goal, else {@code NONE}. */
  private int expand(int arrival, int goal, char[] distances, int bound) {
    int state = states[arrival];
    int time = times[arrival];
    int vertex = graph.vertex(state);
    int since = reservations.freeSince(vertex, time);
    int word = state * words + since / Long.SIZE;
    long bit = 1L << since;
    if ((closed[word] & bit) != 0) {
      return NONE;
    }
    closed[word] |= bit;
    int until = reservations.nextTaken(vertex, time);
    if (vertex == goal && until == reservations.end()) {
      return arrival;
    }
    for (int action = 1; action < graph.actionCount(); action++) {
      int next = graph.successor(state, action);
      if (next == NONE) {
        continue;
      }
      int toGo = distances[next];
      int direction = graph.direction(state, action);
      if (direction != NONE) {
        enter(arrival, next, opposite(direction), Math.min(until, bound - toGo), toGo, bound);
      } else if (time + 1 < until) {
        push(next, time + 1, arrival, time + 1 + toGo, bound);
      }
    }
    return NONE;
  }

  /** Adds the earliest arrival in each free interval of a neighbour, up to {@code last}. */
  private void enter(int parent, int next, int back, int last, int toGo, int bound) {
    int vertex = graph.vertex(next);
    int free = reservations.nextFree(vertex, times[parent] + 1);
    while (free <= last) {
      int until = reservations.nextTaken(vertex, free);
      int arrival = reservations.nextFreeEdge(vertex, back, free - 1) + 1;
      if (arrival <= last && arrival < until) {
        push(next, arrival, parent, arrival + toGo, bound);
      }
      free = reservations.nextFree(vertex, until);
    }
  }

  private void push(int state, int time, int parent, int key, int bound) {
    if (key > bound) {
      return;
    }
    if (count == states.length) {
      states = Arrays.copyOf(states, 2 * count);
      times = Arrays.copyOf(times, 2 * count);
      parents = Arrays.copyOf(parents, 2 * count);
      below = Arrays.copyOf(below, 2 * count);
    }
    states[count] = state;
    times[count] = time;
    parents[count] = parent;
    below[count] = tops[key];
    tops[key] = count++;
  }

  private int[] trace(int last) {
    int[] path = new int[times[last] + 1];
    int end = path.length;
    for (int arrival = last; arrival != NONE; arrival = parents[arrival]) {
      Arrays.fill(path, times[arrival], end, states[arrival]);
      end = times[arrival];
    }
    return path;
  }

  private void clear(int firstKey, int lastKey) {
    if (firstKey <= lastKey) {
      Arrays.fill(tops, firstKey, lastKey + 1, NONE);
    }
    for (int arrival = 0; arrival < count; arrival++) {
      int since = reservations.freeSince(graph.vertex(states[arrival]), times[arrival]);
      closed[states[arrival] * words + since / Long.SIZE] = 0;
    }
  }
}
