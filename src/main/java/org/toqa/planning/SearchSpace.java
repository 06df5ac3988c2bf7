package org.toqa.planning;

import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.OccupancyGrid;

/** What searches on one grid need; used by one thread at a time, then by the next. */
final class SearchSpace {
  final MoveGraph graph;
  final OctileSearch octile;
  final HeadingSearch heading;

  private SearchSpace(OccupancyGrid grid) {
    graph = new MoveGraph(grid);
    octile = new OctileSearch(graph);
    heading = new HeadingSearch(graph, octile);
  }

  /** How many states were ever expanded in this space. */
  long expanded() {
    return octile.expanded() + heading.expanded();
  }

  /** Keeps the last space for the next search on the same grid; any thread may use it. */
  static final class Pool {
    private final AtomicReference<@Nullable SearchSpace> spare = new AtomicReference<>();

    SearchSpace take(OccupancyGrid grid) {
      SearchSpace space = spare.getAndSet(null);
      return space != null && space.graph.grid().equals(grid) ? space : new SearchSpace(grid);
    }

    void giveBack(SearchSpace space) {
      spare.set(space);
    }
  }
}
