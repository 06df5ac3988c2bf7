package org.toqa.planning;

import java.util.BitSet;
import org.toqa.grid.OccupancyGrid;

/**
 * What searches look up of a grid, found once: the moves of each cell, and where straight runs end;
 * 1 3/4 B a cell. It takes over a grid that differs in a few cells at a cost of these cells.
 * Confined to one thread at a time.
 */
final class GridLayout {
  private final MoveGraph graph;
  private final StraightRuns alongRows;
  private final StraightRuns alongColumns;
  private OccupancyGrid grid;
  private int updates;

  GridLayout(OccupancyGrid grid) {
    this.grid = grid;
    graph = new MoveGraph(grid);
    alongRows = StraightRuns.alongRows(grid);
    alongColumns = StraightRuns.alongColumns(grid);
  }

  /**
   * @param changed the cells that are not as in the grid until now, by their index
   */
  void update(OccupancyGrid next, BitSet changed) {
    grid = next;
    updates++;
    graph.update(next, changed);
    for (int cell = changed.nextSetBit(0); cell >= 0; cell = changed.nextSetBit(cell + 1)) {
      alongRows.flip(graph.row(cell), graph.column(cell));
      alongColumns.flip(graph.column(cell), graph.row(cell));
    }
  }

  OccupancyGrid grid() {
    return grid;
  }

  /** How often it has changed. */
  int updates() {
    return updates;
  }

  MoveGraph graph() {
    return graph;
  }

  StraightRuns alongRows() {
    return alongRows;
  }

  StraightRuns alongColumns() {
    return alongColumns;
  }
}
