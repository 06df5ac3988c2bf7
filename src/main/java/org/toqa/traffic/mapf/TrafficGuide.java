package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;
import static org.toqa.traffic.RoadGraph.opposite;

import java.util.Arrays;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.RoadGraph;

/**
 * Distances that know which ways others will take, so that robots part before they meet.
 *
 * <p>Idea: each robot announces its cheapest path. An edge costs a step, half a step more for each
 * robot that announced it in the other direction, and a sixteenth for each that announced a way to
 * the vertex that it leads to. Whoever asks later keeps to aisles that are driven in its direction
 * and that few use.
 *
 * <p>Cost: a search a path over all vertices that are hardly further than the start, with a row of
 * stacks as queue, as costs are small whole numbers.
 *
 * <p>After Z. Chen et al., "Traffic flow optimisation for lifelong multi-agent path finding", AAAI
 * 2024.
 */
final class TrafficGuide {
  /** What a step costs; finer than 1, so that traffic can cost less than a step. */
  static final int STEP = 16;

  /** What a robot costs that announced the edge in the other direction. */
  private static final int ONCOMING = 8;

  /** What a robot costs that announced a way to the same vertex. */
  private static final int CROSSING = 1;

  private static final int MOST_FOR_TRAFFIC = 24 * STEP;

  /** More than an edge can cost, and a power of two. */
  private static final int STACKS = 512;

  /** How far beyond the start distances are known, for when a robot is pushed aside. */
  private static final int MARGIN = 48 * STEP;

  private final RoadGraph roads;

  /** By edge, which is {@code vertex * 4 + direction}: how many have announced it. */
  private final int[] announced;

  /** By vertex: how many have announced an edge that leads to it. */
  private final int[] crossing;

  /** By edge. */
  private final int[] costs;

  private final int[] tops = new int[STACKS];
  private int[] vertices;
  private int[] below;
  private int used;

  TrafficGuide(RoadGraph roads) {
    this.roads = roads;
    announced = new int[roads.vertexCount() * DIRECTIONS];
    crossing = new int[roads.vertexCount()];
    costs = new int[roads.vertexCount() * DIRECTIONS];
    vertices = new int[roads.vertexCount()];
    below = new int[roads.vertexCount()];
    Arrays.fill(costs, STEP);
    Arrays.fill(tops, NONE);
  }

  /**
   * Announces the cheapest path from a start to a goal and answers what it costs to the goal from
   * each vertex, {@link DistanceTables#UNREACHABLE} beyond the margin.
   */
  char[] announce(int start, int goal) {
    char[] toGo = distances(start, goal);
    int v = start;
    while (v != goal && toGo[v] != DistanceTables.UNREACHABLE) {
      int direction = bestDirection(v, toGo);
      int next = roads.neighbour(v, direction);
      announced[v * DIRECTIONS + direction]++;
      crossing[next]++;
      setCosts(v, direction, next);
      v = next;
    }
    return toGo;
  }

  private char[] distances(int start, int goal) {
    char[] toGo = new char[roads.vertexCount()];
    Arrays.fill(toGo, (char) DistanceTables.UNREACHABLE);
    toGo[goal] = 0;
    used = 0;
    int left = push(goal, 0);
    int last = DistanceTables.UNREACHABLE - STACKS;
    for (int cost = 0; left > 0 && cost <= last; cost++) {
      for (int v = pop(cost); v != NONE; v = pop(cost)) {
        left--;
        if (toGo[v] == cost) {
          left += relax(v, toGo);
        }
      }
      if (toGo[start] <= cost) {
        last = Math.min(last, toGo[start] + MARGIN);
      }
    }
    Arrays.fill(tops, NONE);
    return toGo;
  }

  /** Answers how many vertices have come into the queue. */
  private int relax(int vertex, char[] toGo) {
    int count = 0;
    for (int d = 0; d < DIRECTIONS; d++) {
      int from = roads.predecessor(vertex, d);
      if (from == NONE) {
        continue;
      }
      int through = toGo[vertex] + costs[from * DIRECTIONS + opposite(d)];
      if (through < toGo[from]) {
        toGo[from] = (char) through;
        count += push(from, through);
      }
    }
    return count;
  }

  private int push(int vertex, int key) {
    if (used == vertices.length) {
      vertices = Arrays.copyOf(vertices, 2 * used);
      below = Arrays.copyOf(below, 2 * used);
    }
    vertices[used] = vertex;
    below[used] = tops[key % STACKS];
    tops[key % STACKS] = used++;
    return 1;
  }

  private int pop(int key) {
    int entry = tops[key % STACKS];
    if (entry == NONE) {
      return NONE;
    }
    tops[key % STACKS] = below[entry];
    return vertices[entry];
  }

  private int bestDirection(int vertex, char[] toGo) {
    int best = NONE;
    int least = Integer.MAX_VALUE;
    for (int d = 0; d < DIRECTIONS; d++) {
      int next = roads.neighbour(vertex, d);
      if (next != NONE && toGo[next] + costs[vertex * DIRECTIONS + d] < least) {
        least = toGo[next] + costs[vertex * DIRECTIONS + d];
        best = d;
      }
    }
    return best;
  }

  /** After an edge has been announced: it changes the way back, and all ways to its end. */
  private void setCosts(int from, int direction, int to) {
    setCost(to, opposite(direction), from);
    for (int d = 0; d < DIRECTIONS; d++) {
      int beside = roads.predecessor(to, d);
      if (beside != NONE) {
        setCost(beside, opposite(d), to);
      }
    }
  }

  private void setCost(int from, int direction, int to) {
    int oncoming = announced[to * DIRECTIONS + opposite(direction)];
    int traffic = ONCOMING * oncoming + CROSSING * crossing[to];
    costs[from * DIRECTIONS + direction] = STEP + Math.min(MOST_FOR_TRAFFIC, traffic);
  }
}
