package org.toqa.planning;

import java.util.function.LongConsumer;

/**
 * Shortest paths that a robot can drive in arcs, always facing forward: states are (cell, heading),
 * and there are three moves, along the heading or along heading +-45 degrees (Tanta, "Map and
 * planner"). The heading is free at start and goal.
 *
 * <p>Where those moves have no path, turns on the spot are allowed too: the shortest path then
 * counts half a cell for each 45 degrees turned, and {@link Path#turnsOnSpot} is positive. A path
 * that the eight plain moves have always has one of these two.
 *
 * <p>Jump points are asked first, as in {@link JumpPointSearch}. No path with headings is shorter
 * than theirs, so where its moves can be ordered without a bend over 45 degrees ({@link
 * PieceOrder}), that is the answer. Otherwise octile distances from the goal, as far as needed, are
 * the lower bound that guides an A* over headings; they stay for the next path to the same goal on
 * the same grid.
 *
 * <p>A planner keeps the layouts of its last grids, 1 3/4 B a cell each, and its room, 12 B a cell
 * and 16 more after the first search over headings. Beyond that it allocates what it answers. Any
 * thread may plan; see {@link GridPlanner}.
 */
public final class HeadingAStar extends GridPlanner {

  public HeadingAStar() {
    this(expanded -> {});
  }

  /**
   * @param expandedListener is told after each search how many states it has expanded
   */
  public HeadingAStar(LongConsumer expandedListener) {
    super(HeadingGridSearch::new, expandedListener);
  }
}
