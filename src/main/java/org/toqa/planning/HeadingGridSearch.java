package org.toqa.planning;

import java.util.List;
import java.util.Optional;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/** The two searches of {@link HeadingAStar} on one grid. */
final class HeadingGridSearch implements GridSearch {
  private final OccupancyGrid grid;
  private final OctileSearch octile;
  private final HeadingSearch heading;

  HeadingGridSearch(OccupancyGrid grid) {
    this.grid = grid;
    MoveGraph graph = new MoveGraph(grid);
    octile = new OctileSearch(graph);
    heading = new HeadingSearch(graph, octile);
  }

  @Override
  public OccupancyGrid grid() {
    return grid;
  }

  @Override
  public Optional<Path> path(Cell start, Cell goal) {
    int from = grid.index(start);
    int to = grid.index(goal);
    octile.begin(to, from);
    if (octile.distance(from) == OctileSearch.UNREACHABLE) {
      return Optional.empty();
    }
    List<Heading> inArcs = heading.moves(from, to, false);
    List<Heading> moves = inArcs.isEmpty() ? heading.moves(from, to, true) : inArcs;
    return Optional.of(Path.of(start, moves, true));
  }

  @Override
  public long expandedCount() {
    return octile.expandedCount() + heading.expandedCount();
  }
}
