package org.toqa.traffic.oneshot;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;
import static org.toqa.traffic.RoadGraph.opposite;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.RoadGraph;

/**
 * The quickest route of one robot among the routes of the others.
 *
 * <p>Idea: A* whose states are not (vertex, time) but (vertex, time while it stays free): within
 * such an interval only the earliest arrival counts, since one can wait. The estimate is the exact
 * distance without others; whole numbers as keys make the queue a row of stacks.
 *
 * <p>M. Phillips and M. Likhachev, "SIPP: Safe interval path planning for dynamic environments",
 * ICRA 2011.
 */
final class SafeIntervalSearch {
  private final RoadGraph roads;
  private final Timetable timetable;

  /** The arrivals found so far, in the order in which they were found. */
  private int[] vertices = new int[1024];

  private int[] times = new int[1024];
  private int[] parents = new int[1024];
  private int[] below = new int[1024];
  private int count;
  private long effort;

  /** The top of the stack of each key; the key is arrival plus distance to go. */
  private final int[] tops;

  /** Bit by start of a free interval: its earliest arrival is known. */
  private final long[] closed;

  private final int words;

  SafeIntervalSearch(RoadGraph roads, Timetable timetable) {
    this.roads = roads;
    this.timetable = timetable;
    this.words = timetable.end() >> 6;
    this.closed = new long[roads.vertices() * words];
    this.tops = new int[timetable.end() + 1];
    Arrays.fill(tops, NONE);
  }

  /**
   * @param distances steps from each vertex to the goal
   * @param latest when it has to have arrived
   * @return the vertices at the times 0, 1, 2 ... up to the arrival, from where on the goal stays
   *     free for ever; null where there is no such route
   */
  int @Nullable [] route(int start, int goal, char[] distances, int latest) {
    int bound = Math.min(latest, timetable.end() - 1);
    count = 0;
    if (!timetable.isTaken(start, 0)) {
      push(start, 0, NONE, distances[start], bound);
    }
    int found = NONE;
    int key = distances[start];
    for (; key <= bound && found == NONE; key++) {
      while (tops[key] != NONE && found == NONE) {
        int state = tops[key];
        tops[key] = below[state];
        found = expand(state, goal, distances, bound);
      }
    }
    int[] route = found == NONE ? null : trace(found);
    clear(distances[start], bound);
    effort += count;
    return route;
  }

  /** Arrivals looked at in all searches so far: a measure of work that needs no clock. */
  long effort() {
    return effort;
  }

  /** Answers the state itself where it is the goal, else {@code NONE}. */
  private int expand(int state, int goal, char[] distances, int bound) {
    int v = vertices[state];
    int t = times[state];
    int since = timetable.freeSince(v, t);
    int word = v * words + (since >> 6);
    long bit = 1L << since;
    if ((closed[word] & bit) != 0) {
      return NONE;
    }
    closed[word] |= bit;
    int until = timetable.nextTaken(v, t);
    if (v == goal && until == timetable.end()) {
      return state;
    }
    for (int d = 0; d < DIRECTIONS; d++) {
      int u = roads.neighbour(v, d);
      if (u != NONE) {
        enter(state, u, opposite(d), Math.min(until, bound - distances[u]), distances[u], bound);
      }
    }
    return NONE;
  }

  /** Adds the earliest arrival in each free interval of a neighbour. */
  private void enter(int state, int u, int back, int last, int toGo, int bound) {
    int arrival = timetable.nextFree(u, times[state] + 1);
    while (arrival <= last) {
      int until = timetable.nextTaken(u, arrival);
      int clear = timetable.nextUndriven(u, back, arrival - 1) + 1;
      if (clear <= last && clear < until) {
        push(u, clear, state, clear + toGo, bound);
      }
      arrival = timetable.nextFree(u, until);
    }
  }

  private void push(int vertex, int time, int parent, int key, int bound) {
    if (key > bound) {
      return;
    }
    if (count == vertices.length) {
      vertices = Arrays.copyOf(vertices, 2 * count);
      times = Arrays.copyOf(times, 2 * count);
      parents = Arrays.copyOf(parents, 2 * count);
      below = Arrays.copyOf(below, 2 * count);
    }
    vertices[count] = vertex;
    times[count] = time;
    parents[count] = parent;
    below[count] = tops[key];
    tops[key] = count++;
  }

  private int[] trace(int last) {
    int[] route = new int[times[last] + 1];
    int end = route.length;
    for (int state = last; state != NONE; state = parents[state]) {
      Arrays.fill(route, times[state], end, vertices[state]);
      end = times[state];
    }
    return route;
  }

  private void clear(int firstKey, int lastKey) {
    if (firstKey <= lastKey) {
      Arrays.fill(tops, firstKey, lastKey + 1, NONE);
    }
    for (int state = 0; state < count; state++) {
      int since = timetable.freeSince(vertices[state], times[state]);
      closed[vertices[state] * words + (since >> 6)] = 0;
    }
  }
}
