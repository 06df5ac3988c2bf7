package org.toqa.planning;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;

/**
 * A* over (cell, heading in which the cell was entered). A move keeps the heading or changes it by
 * 45 degrees, which the robot drives as an arc; a larger change is a turn on the spot, where it is
 * allowed at all.
 *
 * <p>The lower bound for the rest of the path is the exact octile distance, found on demand by an
 * {@link OctileSearch} from the goal: it drops only the rule about headings, so few states beyond
 * the best paths are looked at (as the reverse resumable A* of Silver, "Cooperative pathfinding",
 * 2005; A*: Hart, Nilsson and Raphael, 1968). Confined to one thread.
 */
final class HeadingSearch {
  private static final int UNKNOWN = Integer.MAX_VALUE;
  private static final int EXPANSIONS_A_CHECK = 1024;

  private final MoveGraph graph;
  private final OctileSearch toGoal;

  /** By {@code 8 cell + heading}. */
  private final int[] g;

  /** One bit a heading: g is final. */
  private final byte[] closed;

  /** Whether g and closed of a cell belong to this search. */
  private final int[] stamp;

  private final OpenList open = new OpenList();
  private int generation;
  private long expandedCount;

  /** The largest change of heading, in eighths of a turn. */
  private int largestTurn;

  HeadingSearch(MoveGraph graph, OctileSearch toGoal) {
    this.graph = graph;
    this.toGoal = toGoal;
    g = new int[8 * graph.size()];
    closed = new byte[graph.size()];
    stamp = new int[graph.size()];
  }

  /**
   * The moves of a shortest path, empty where there is none; {@link OctileSearch#begin} was called
   * with the goal as its source.
   *
   * @param start not the goal
   * @param turnsOnSpot whether the robot may also turn on the spot
   */
  List<Heading> moves(int start, int goal, boolean turnsOnSpot) {
    if (generation == Integer.MAX_VALUE) {
      generation = 0;
      Arrays.fill(stamp, 0);
    }
    generation++;
    largestTurn = turnsOnSpot ? 4 : 1;
    open.clear();
    touch(start);
    for (int heading = 0; heading < 8; heading++) {
      reach(8 * start + heading, 0);
    }
    while (!open.isEmpty()) {
      int state = open.pop();
      int cell = state >> 3;
      int bit = 1 << (state & 7);
      if ((closed[cell] & bit) == 0) {
        closed[cell] |= (byte) bit;
        if (cell == goal) {
          return movesTo(state);
        }
        expand(state);
      }
    }
    return List.of();
  }

  /** How many states were ever expanded. */
  long expandedCount() {
    return expandedCount;
  }

  private void expand(int state) {
    expandedCount++;
    if (expandedCount % EXPANSIONS_A_CHECK == 0) {
      SearchLimit.check();
    }
    int cell = state >> 3;
    int moves = graph.moves(cell);
    for (int turn = -largestTurn; turn <= largestTurn && turn < 4; turn++) {
      int heading = state + turn & 7;
      if ((moves >> heading & 1) == 1) {
        int next = graph.target(cell, heading);
        touch(next);
        if ((closed[next] >> heading & 1) == 0) {
          reach(8 * next + heading, g[state] + cost(turn, heading));
        }
      }
    }
  }

  private void reach(int state, int length) {
    if (length < g[state]) {
      g[state] = length;
      open.push(state, length, toGoal.distance(state >> 3));
    }
  }

  private void touch(int cell) {
    if (stamp[cell] != generation) {
      stamp[cell] = generation;
      closed[cell] = 0;
      Arrays.fill(g, 8 * cell, 8 * cell + 8, UNKNOWN);
    }
  }

  /** A move after a change of heading by so many eighths of a turn. */
  private static int cost(int turn, int heading) {
    int eighthsOnSpot = Math.abs(turn) <= 1 ? 0 : Math.abs(turn);
    return eighthsOnSpot * MoveCost.EIGHTH_TURN + MoveGraph.cost(heading);
  }

  private List<Heading> movesTo(int goalState) {
    Deque<Heading> moves = new ArrayDeque<>();
    for (int state = goalState; g[state] > 0; state = predecessor(state)) {
      moves.addFirst(Heading.of(state & 7));
    }
    return List.copyOf(moves);
  }

  /** Costs are exact integers, so the predecessor is the state whose sum fits. */
  private int predecessor(int state) {
    int heading = state & 7;
    int cell = graph.target(state >> 3, heading + 4 & 7);
    for (int i = 0; i <= 2 * largestTurn; i++) {
      int turn = (i & 1) == 0 ? i / 2 : -(i + 1) / 2; // 0, -1, 1, -2, ...: rather straight
      int before = 8 * cell + (heading - turn & 7);
      if (g[before] != UNKNOWN && g[before] + cost(turn, heading) == g[state]) {
        return before;
      }
    }
    throw new IllegalStateException("No state leads to " + graph.cell(state >> 3) + ".");
  }
}
