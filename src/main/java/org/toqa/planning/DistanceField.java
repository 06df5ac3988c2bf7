package org.toqa.planning;

import java.util.Arrays;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * The lengths of the shortest octile paths to one cell from all others of a grid. Immutable; for
 * any thread.
 */
public final class DistanceField {
  private static final float UNREACHABLE = Float.POSITIVE_INFINITY;

  private final OccupancyGrid grid;
  private final float[] lengths;

  /**
   * Looks at every cell once.
   *
   * @param grid inflated; a target that is not free cannot be reached
   */
  public DistanceField(OccupancyGrid grid, Cell target) {
    this.grid = grid;
    lengths = new float[grid.width() * grid.height()];
    Arrays.fill(lengths, UNREACHABLE);
    if (grid.isFree(target)) {
      fill(grid.index(target));
    }
  }

  private void fill(int target) {
    MoveGraph graph = new MoveGraph(grid);
    OctileSearch search = new OctileSearch(graph);
    search.begin(graph, target, target);
    for (int cell = 0; cell < lengths.length; cell++) {
      int length = search.distance(cell);
      if (length != OctileSearch.UNREACHABLE) {
        lengths[cell] = (float) length / MoveCost.STRAIGHT;
      }
    }
  }

  /** The length of the shortest path from a cell, in cells; infinite where there is no path. */
  public double from(Cell cell) {
    return grid.contains(cell) ? lengths[grid.index(cell)] : UNREACHABLE;
  }
}
