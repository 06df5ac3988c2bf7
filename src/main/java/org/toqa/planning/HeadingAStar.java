package org.toqa.planning;

import java.util.function.LongConsumer;

/**
 * Shortest paths that a robot can drive in arcs, always facing forward: A* with state (cell,
 * heading) and three moves, along the heading or along heading +-45 degrees (Tanta, "Map and
 * planner"). The heading is free at start and goal.
 *
 * <p>Where those moves have no path, turns on the spot are allowed too: the shortest path then
 * counts half a cell for each 45 degrees turned, and {@link Path#turnsOnSpot} is positive. A path
 * that the eight plain moves have always has one of these two.
 *
 * <p>Two searches: octile distances from the goal, as far as needed, are the lower bound that
 * guides the search over headings.
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
