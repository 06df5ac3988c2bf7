package org.toqa.planning;

import java.util.Optional;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/** The search of {@link JumpPointSearch}, and the last grids as it sees them. */
final class JumpPointGridSearch implements GridSearch {
  private final GridLayouts layouts = new GridLayouts();
  private final JumpPoints jumpPoints;
  private final OctileSearch octile;
  private final MoveSequence moves = new MoveSequence();

  JumpPointGridSearch(OccupancyGrid grid) {
    GridLayout layout = layouts.layout(grid);
    jumpPoints = new JumpPoints(layout);
    octile = new OctileSearch(layout.graph());
  }

  @Override
  public Optional<Path> path(OccupancyGrid grid, Cell start, Cell goal) {
    GridLayout layout = layouts.layout(grid);
    int from = grid.index(start);
    int to = grid.index(goal);
    if (layout.graph().isDirected()) { // jump points are for moves that lead back too
      return octilePath(layout.graph(), start, from, to);
    }
    if (!jumpPoints.search(layout, from, to)) {
      return Optional.empty();
    }
    jumpPoints.findMoves(moves);
    return Optional.of(Path.of(start, moves, false));
  }

  private Optional<Path> octilePath(MoveGraph graph, Cell start, int from, int to) {
    octile.begin(graph, to, from);
    if (octile.distance(from) == OctileSearch.UNREACHABLE) {
      return Optional.empty();
    }
    moves.clear();
    int cell = from;
    while (cell != to) {
      int heading = shortestMove(graph, cell);
      moves.add(heading, 1);
      cell = graph.target(cell, heading);
    }
    return Optional.of(Path.of(start, moves, false));
  }

  private int shortestMove(MoveGraph graph, int cell) {
    int length = octile.distance(cell);
    for (int open = graph.moves(cell); open != 0; open &= open - 1) {
      int heading = Integer.numberOfTrailingZeros(open);
      int rest = length - MoveGraph.cost(heading);
      if (octile.distanceWithin(graph.target(cell, heading), rest) == rest) {
        return heading;
      }
    }
    throw new IllegalStateException("A distance without a way.");
  }

  @Override
  public long expandedCount() {
    return jumpPoints.expandedCount() + octile.expandedCount();
  }
}
