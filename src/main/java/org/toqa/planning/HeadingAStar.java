package org.toqa.planning;

import java.util.List;
import java.util.function.LongConsumer;
import org.toqa.grid.Cell;

/**
 * Shortest ways that a robot can drive in arcs, always facing forward: A* with state (cell,
 * heading) and three moves, along the heading or along heading +-45 degrees (Tanta, "Map and
 * planner"). The heading is free at start and goal.
 *
 * <p>Where those moves have no way, turns on the spot are allowed too: the shortest way then counts
 * half a cell for each 45 degrees turned, and {@link Path#turnsOnSpot} is positive. A way that the
 * eight plain moves have always has one of these two.
 *
 * <p>Two searches: octile distances from the goal, as far as needed, are the lower bound that
 * guides the search over headings.
 */
public final class HeadingAStar extends GridAStar {

  public HeadingAStar() {
    this(expanded -> {});
  }

  /**
   * @param effort is told after each search how many states it has expanded
   */
  public HeadingAStar(LongConsumer effort) {
    super(effort);
  }

  @Override
  Path search(SearchSpace space, Cell start, Cell goal) {
    int from = space.graph.grid().index(start);
    int to = space.graph.grid().index(goal);
    List<Heading> moves = space.heading.way(from, to, false);
    return moves.isEmpty()
        ? Path.of(start, space.heading.way(from, to, true), true)
        : Path.of(start, moves, true);
  }
}
