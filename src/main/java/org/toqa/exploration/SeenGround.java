package org.toqa.exploration;

import java.util.BitSet;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.CellRuns;
import org.toqa.grid.OccupancyGrid;

/**
 * What is known of ground, cell by cell as in an {@link OccupancyGrid}; what is neither free nor
 * occupied is unknown. Immutable.
 *
 * @param resolution metres along a cell's side
 * @param origin metres, the lower left corner in the map frame
 */
public record SeenGround(
    int width, int height, double resolution, Vec2 origin, CellRuns free, CellRuns occupied) {

  /** Square metres that are known to be free or occupied. */
  public double area() {
    return (free.cells().cardinality() + occupied.cells().cardinality()) * resolution * resolution;
  }

  /**
   * A map for robots to drive by: free is what was seen free, and all else is a wall, also the
   * unknown. It is as large as what was seen, and what else is to lie on it.
   *
   * @param places metres, map frame
   */
  public OccupancyGrid map(List<Vec2> places) {
    BitSet known = free.cells();
    known.or(occupied.cells());
    OccupancyGrid frame = new OccupancyGrid(width, height, resolution, origin, new BitSet());
    List<Cell> cells =
        Stream.concat(known.stream().mapToObj(frame::cell), places.stream().map(frame::cellAt))
            .toList();
    if (cells.isEmpty()) {
      return new OccupancyGrid(1, 1, resolution, origin, new BitSet());
    }
    int west = cells.stream().mapToInt(Cell::column).min().orElseThrow();
    int east = cells.stream().mapToInt(Cell::column).max().orElseThrow();
    int north = cells.stream().mapToInt(Cell::row).min().orElseThrow();
    int south = cells.stream().mapToInt(Cell::row).max().orElseThrow();
    int columns = east - west + 1;
    int rows = south - north + 1;
    BitSet walls = new BitSet(columns * rows);
    walls.set(0, columns * rows);
    free.cells().stream()
        .mapToObj(frame::cell)
        .forEach(cell -> walls.clear((cell.row() - north) * columns + cell.column() - west));
    Vec2 corner = origin.plus(new Vec2(west, height - 1 - south).times(resolution));
    return new OccupancyGrid(columns, rows, resolution, corner, walls);
  }
}
