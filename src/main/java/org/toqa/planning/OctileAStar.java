package org.toqa.planning;

import java.util.function.LongConsumer;
import org.toqa.grid.Cell;

/**
 * Shortest ways with eight moves, whatever the corners: A* (Hart, Nilsson, Raphael, 1968) from the
 * goal to the start. For benchmarks, and as the length below which no way with headings can be.
 */
public final class OctileAStar extends GridAStar {

  public OctileAStar() {
    this(expanded -> {});
  }

  /**
   * @param effort is told after each search how many states it has expanded
   */
  public OctileAStar(LongConsumer effort) {
    super(effort);
  }

  @Override
  Path search(SearchSpace space, Cell start, Cell goal) {
    int from = space.graph.grid().index(start);
    return Path.of(start, space.octile.wayToSource(from), false);
  }
}
