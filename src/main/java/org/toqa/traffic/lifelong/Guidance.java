package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;
import static org.toqa.traffic.RoadGraph.opposite;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Objects;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.stream.IntStream;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.Spacing;
import org.toqa.traffic.mapf.StateGraph;

/**
 * Distances that know of oncoming traffic, so that robots keep to the side on which others drive in
 * the same direction, before they meet.
 *
 * <p>Idea: each robot announces the edges of its shortest path. An edge costs a step, and more for
 * each robot that announced it in the other direction, or announced any way through the vertex that
 * it leads to. Who plans next therefore prefers an aisle that is driven in its direction, and one
 * that few use; one-way streets form by themselves, and dissolve when the traffic changes.
 *
 * <p>Cost: one A* search a path, from the goal to the robot and a margin beyond, so that distances
 * are known in an ellipse around both: each state there once or a few times, with a row of stacks
 * as queue, as costs are small whole numbers.
 *
 * <p>After Z. Chen et al., "Traffic flow optimisation for lifelong multi-agent path finding", AAAI
 * 2024.
 */
final class Guidance {
  /** What a step costs; finer than 1, so that traffic can cost less than a step. */
  static final int STEP = 8;

  /** What a robot costs that announced the edge in the other direction. */
  private static final int ONCOMING = 5;

  /** Robots that announced a way through the vertex, for each {@link #STEP} that they cost. */
  private static final int CROSSING_PER_STEP = 16;

  /** Also what it costs to enter a vertex on which a robot is fixed. */
  private static final int MOST_FOR_TRAFFIC = 16 * STEP;

  /** More than a key can rise at an edge, and a power of two. */
  private static final int STACKS = 256;

  /** How far beyond the robot distances are known, for when it is pushed aside. */
  static final int MARGIN = 32 * STEP;

  private final StateGraph graph;

  private final Spacing spacing;

  /**
   * By edge, which is {@code vertex * 4 + direction}: how many announced edges lead the other way
   * so near to it that who drives there has to be passed.
   */
  private final int[] oncoming;

  /** By vertex: how many have announced an edge that leads to it. */
  private final int[] crossing;

  /** The vertices on which a robot is fixed. */
  private BitSet fixed = new BitSet();

  /** Memory of searches that are over, for the next ones: a large floor wants megabytes. */
  private final Queue<char[]> spareCosts = new ConcurrentLinkedQueue<>();

  private final Queue<BucketQueue> spareQueues = new ConcurrentLinkedQueue<>();

  private final int[] columns;
  private final int[] rows;

  /** Robots may be on any two vertices at once. */
  Guidance(StateGraph graph) {
    this(graph, Spacing.none(graph.roads()));
  }

  /**
   * @param spacing which vertices cannot be taken at once
   */
  Guidance(StateGraph graph, Spacing spacing) {
    this.graph = graph;
    this.spacing = spacing;
    this.columns =
        IntStream.range(0, graph.roads().vertexCount()).map(graph.roads()::columnOf).toArray();
    this.rows = IntStream.range(0, graph.roads().vertexCount()).map(graph.roads()::rowOf).toArray();
    this.oncoming = new int[graph.roads().vertexCount() * DIRECTIONS];
    this.crossing = new int[graph.roads().vertexCount()];
  }

  /** The vertices on which robots are fixed: paths lead round them, if there is a way. */
  void setFixed(BitSet vertices) {
    fixed = vertices;
  }

  /**
   * Costs to the goal by state; {@link DistanceTables#UNREACHABLE} where there is no path, and
   * beyond the margin. Any number of threads may call it while nobody announces.
   */
  char[] distances(int start, int goal) {
    char[] costs = Objects.requireNonNullElseGet(spareCosts.poll(), this::newCosts);
    Arrays.fill(costs, (char) DistanceTables.UNREACHABLE);
    BucketQueue open = Objects.requireNonNullElseGet(spareQueues.poll(), this::newQueue);
    int first = lowerBound(goal, graph.vertex(start));
    for (int heading = 0; heading < graph.headingCount(); heading++) {
      int state = graph.state(goal, heading);
      costs[state] = 0;
      open.push(state, first);
    }
    int last = DistanceTables.UNREACHABLE - STACKS;
    for (int key = first; key <= last && open.size > 0; key++) {
      for (int state = open.pop(key); state != NONE; state = open.pop(key)) {
        if (costs[state] + lowerBound(graph.vertex(state), graph.vertex(start)) == key) {
          relax(state, graph.vertex(start), costs, open);
        }
      }
      if (costs[start] <= key) {
        last = Math.min(last, costs[start] + MARGIN);
      }
    }
    open.clear();
    spareQueues.add(open);
    return costs;
  }

  private char[] newCosts() {
    return new char[graph.stateCount()];
  }

  private BucketQueue newQueue() {
    return new BucketQueue(graph.stateCount());
  }

  /** Takes back costs that nobody uses any more: the next ones are written there. */
  void recycle(char[] costs) {
    if (costs.length == graph.stateCount()) {
      spareCosts.add(costs);
    }
  }

  /** What the path between two vertices costs at least: the steps on an empty floor. */
  private int lowerBound(int from, int to) {
    return STEP * (Math.abs(columns[from] - columns[to]) + Math.abs(rows[from] - rows[to]));
  }

  private void relax(int state, int start, char[] costs, BucketQueue open) {
    for (int action = 1; action < graph.actionCount(); action++) {
      int from = graph.predecessor(state, action);
      if (from == NONE) {
        continue;
      }
      int through = costs[state] + cost(from, state, action);
      if (through < costs[from]) {
        costs[from] = (char) through;
        open.push(from, through + lowerBound(graph.vertex(from), start));
      }
    }
  }

  private int cost(int from, int to, int action) {
    int direction = graph.direction(from, action);
    if (direction == NONE) {
      return STEP;
    }
    int vertex = graph.vertex(to);
    int met = oncoming[graph.vertex(from) * DIRECTIONS + direction];
    int traffic = ONCOMING * met + STEP * crossing[vertex] / CROSSING_PER_STEP;
    return STEP + (fixed.get(vertex) ? MOST_FOR_TRAFFIC : Math.min(MOST_FOR_TRAFFIC, traffic));
  }

  /** Announces the cheapest path from a state on; answers its edges, to withdraw them. */
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
      state = graph.successor(state, action);
      action = bestAction(state, costs);
    }
    int[] path = Arrays.copyOf(edges, count);
    count(path, 1);
    return path;
  }

  private int bestAction(int state, char[] costs) {
    int best = StateGraph.WAIT;
    int least = costs[state];
    for (int action = 1; action < graph.actionCount(); action++) {
      int next = graph.successor(state, action);
      if (next != NONE && costs[next] < least) {
        least = costs[next];
        best = action;
      }
    }
    return best;
  }

  void withdraw(int[] path) {
    count(path, -1);
  }

  private void count(int[] path, int robots) {
    for (int edge : path) {
      int direction = edge % DIRECTIONS;
      for (int other : spacing.opposite(edge / DIRECTIONS, direction)) {
        if (other % DIRECTIONS == opposite(direction)) {
          oncoming[other] += robots;
        }
      }
      crossing[graph.roads().neighbour(edge / DIRECTIONS, direction)] += robots;
    }
  }

  /** A priority queue for keys that never lie further apart than there are stacks. */
  private static final class BucketQueue {
    private final int[] tops = new int[STACKS];
    private int[] states;
    private int[] below;
    private int used;
    private int free = NONE;
    private int size;

    BucketQueue(int capacity) {
      states = new int[capacity];
      below = new int[capacity];
      Arrays.fill(tops, NONE);
    }

    void clear() {
      Arrays.fill(tops, NONE);
      used = 0;
      free = NONE;
      size = 0;
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
