package org.toqa.traffic.floor;

import java.util.List;
import java.util.stream.IntStream;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;

/** The cells that a disc touches. */
final class SweptCells {
  private SweptCells() {}

  /**
   * The cells under a disc at rest; parts outside the grid are left out.
   *
   * @param radius metres
   */
  static CellSet at(OccupancyGrid grid, Vec2 centre, double radius) {
    return CellSet.of(indices(grid, new Disc(radius).cellsAt(grid, centre)).toArray());
  }

  /** The cells that the disc touches on a straight line. */
  static CellSet alongLine(OccupancyGrid grid, Vec2 from, Vec2 to, double radius) {
    return CellSet.of(indices(grid, new Disc(radius).cellsAlong(grid, from, to)).toArray());
  }

  private static IntStream indices(OccupancyGrid grid, List<Cell> cells) {
    return cells.stream().mapToInt(grid::index);
  }
}
