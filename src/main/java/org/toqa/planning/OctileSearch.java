package org.toqa.planning;

import java.util.Arrays;

/**
 * A* over cells with eight moves, resumable: it answers the exact distance from its source to one
 * cell after the other and keeps what it has found between the questions (reverse resumable A*,
 * Silver, "Cooperative Pathfinding", 2005). Moves are symmetric, so the distance from a source is
 * also the distance to it.
 *
 * <p>Flat arrays; a generation stamp makes them new without clearing. Confined to one thread.
 */
final class OctileSearch {
  static final int UNREACHABLE = Integer.MAX_VALUE;
  private static final int EXPANSIONS_A_CHECK = 1024;

  private final int[] g;

  /** {@code 2 generation}: g is valid; {@code 2 generation + 1}: and final. */
  private final int[] stamp;

  private final OpenList open = new OpenList();
  private final MoveGraph graph;
  private int generation;
  private long expandedCount;
  private int towardColumn;
  private int towardRow;

  OctileSearch(MoveGraph graph) {
    this.graph = graph;
    g = new int[graph.size()];
    stamp = new int[graph.size()];
  }

  /**
   * Begins anew.
   *
   * @param toward the cell near which the questions will be: the search leans to it, the answers do
   *     not depend on it
   */
  void begin(int source, int toward) {
    if (generation == Integer.MAX_VALUE / 2 - 1) {
      generation = 0;
      Arrays.fill(stamp, 0);
    }
    generation++;
    towardColumn = graph.column(toward);
    towardRow = graph.row(toward);
    open.clear();
    g[source] = 0;
    stamp[source] = 2 * generation;
    open.push(source, 0, h(source));
  }

  /** Exact octile distance between the source and a cell, or {@link #UNREACHABLE}. */
  int distance(int cell) {
    int closed = 2 * generation + 1;
    while (stamp[cell] != closed) {
      if (open.isEmpty()) {
        return UNREACHABLE;
      }
      int next = open.pop();
      if (stamp[next] != closed) {
        stamp[next] = closed;
        expand(next, closed);
      }
    }
    return g[cell];
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
    for (int moves = graph.moves(cell); moves != 0; moves &= moves - 1) {
      int heading = Integer.numberOfTrailingZeros(moves);
      int next = graph.target(cell, heading);
      int known = stamp[next];
      int length = g[cell] + MoveGraph.cost(heading);
      if (known != closed && (known != closed - 1 || length < g[next])) {
        g[next] = length;
        stamp[next] = closed - 1;
        open.push(next, length, h(next));
      }
    }
  }

  private int h(int cell) {
    return MoveCost.octile(graph.column(cell) - towardColumn, graph.row(cell) - towardRow);
  }
}
