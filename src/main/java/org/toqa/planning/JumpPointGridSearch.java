package org.toqa.planning;

import java.util.Optional;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/** The search of {@link JumpPointSearch}, and the last grids as it sees them. */
final class JumpPointGridSearch implements GridSearch {
  private final GridLayouts layouts = new GridLayouts();
  private final JumpPoints jumpPoints;
  private final MoveSequence moves = new MoveSequence();

  JumpPointGridSearch(OccupancyGrid grid) {
    jumpPoints = new JumpPoints(layouts.layout(grid));
  }

  @Override
  public Optional<Path> path(OccupancyGrid grid, Cell start, Cell goal) {
    if (!jumpPoints.search(layouts.layout(grid), grid.index(start), grid.index(goal))) {
      return Optional.empty();
    }
    jumpPoints.findMoves(moves);
    return Optional.of(Path.of(start, moves, false));
  }

  @Override
  public long expandedCount() {
    return jumpPoints.expandedCount();
  }
}
