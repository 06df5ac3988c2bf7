package org.toqa.planning;

import java.util.Arrays;

/**
 * A* over cells with eight moves, resumable: it answers the exact distance to its target from one
 * cell after the other and keeps what it has found between the questions (reverse resumable A*,
 * Silver, "Cooperative Pathfinding", 2005).
 *
 * <p>Flat arrays; a generation stamp makes them new without clearing. Confined to one thread.
 */
final class OctileSearch {
  static final int UNREACHABLE = Integer.MAX_VALUE;
  private static final int EXPANSIONS_A_CHECK = 1024;

  private int[] g = {};

  /** {@code 2 generation}: g is valid; {@code 2 generation + 1}: and final. */
  private int[] stamp = {};

  private final BucketQueue open = new BucketQueue();
  private MoveGraph graph;
  private int generation;
  private long expandedCount;
  private int towardColumn;
  private int towardRow;

  OctileSearch(MoveGraph graph) {
    this.graph = graph;
  }

  /**
   * Begins anew.
   *
   * @param toward the cell near which the questions will be: the search leans to it, the answers do
   *     not depend on it
   */
  void begin(MoveGraph moveGraph, int target, int toward) {
    graph = moveGraph;
    if (stamp.length < graph.size()) {
      g = new int[graph.size()];
      stamp = new int[graph.size()];
      generation = 0;
    }
    if (generation == Integer.MAX_VALUE / 2 - 1) {
      generation = 0;
      Arrays.fill(stamp, 0);
    }
    generation++;
    towardColumn = graph.column(toward);
    towardRow = graph.row(toward);
    int length = octile(target);
    open.clear(length);
    g[target] = 0;
    stamp[target] = 2 * generation;
    open.push(target, length);
  }

  /** Whether the distance of a cell has been found. */
  boolean isKnown(int cell) {
    return stamp[cell] == 2 * generation + 1;
  }

  /** Whether it has come out that no path leads from a cell to the target. */
  boolean isCutOff(int cell) {
    return open.isEmpty() && !isKnown(cell);
  }

  /** Exact octile distance from a cell to the target, or {@link #UNREACHABLE}. */
  int distance(int cell) {
    return search(cell, Integer.MAX_VALUE) ? g[cell] : UNREACHABLE;
  }

  /** The same, or {@link #UNREACHABLE} where it is above a limit. */
  int distanceWithin(int cell, int limit) {
    // what is still open is at least key - octile away: at most so much can be of use
    return (isKnown(cell) || search(cell, limit + octile(cell))) && g[cell] <= limit
        ? g[cell]
        : UNREACHABLE;
  }

  /** Whether the distance is known when all below a key has been looked at. */
  private boolean search(int cell, int limit) {
    int closed = 2 * generation + 1;
    while (stamp[cell] != closed) {
      int next = open.pop(limit);
      if (next < 0) {
        return false;
      }
      if (stamp[next] != closed) {
        stamp[next] = closed;
        expand(next, closed);
      }
    }
    return true;
  }

  /** How many cells were ever expanded. */
  long expandedCount() {
    return expandedCount;
  }

  private void expand(int cell, int closed) {
    expandedCount++;
    if (expandedCount % EXPANSIONS_A_CHECK == 0) {
      SearchLimit.check();
    }
    int columns = graph.column(cell) - towardColumn;
    int rows = graph.row(cell) - towardRow;
    for (int moves = graph.movesInto(cell); moves != 0; moves &= moves - 1) {
      int heading = Integer.numberOfTrailingZeros(moves);
      int next = graph.target(cell, heading);
      int known = stamp[next];
      int length = g[cell] + MoveGraph.cost(heading);
      if (known != closed && (known != closed - 1 || length < g[next])) {
        g[next] = length;
        stamp[next] = closed - 1;
        Heading h = Heading.of(heading);
        open.push(next, length + MoveCost.octile(columns + h.dColumn(), rows + h.dRow()));
      }
    }
  }

  private int octile(int cell) {
    return MoveCost.octile(graph.column(cell) - towardColumn, graph.row(cell) - towardRow);
  }
}
