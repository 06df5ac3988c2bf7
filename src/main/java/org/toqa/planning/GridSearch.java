package org.toqa.planning;

import java.util.Optional;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * A search with its room, and what it has looked up of the last grids; used by one thread at a
 * time, then by the next.
 */
interface GridSearch {

  /**
   * A shortest path, empty where there is none.
   *
   * @param start free
   * @param goal free, not the start
   */
  Optional<Path> path(OccupancyGrid grid, Cell start, Cell goal);

  /** How many states this search has ever expanded. */
  long expandedCount();
}
