package org.toqa.planning;

import java.util.Arrays;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * The lengths of the shortest octile paths between one cell and all others of a grid. Immutable;
 * for any thread.
 */
public final class DistanceField {
  private static final float UNREACHABLE = Float.POSITIVE_INFINITY;

  private final OccupancyGrid grid;
  private final float[] lengths;

  /**
   * Looks at every cell once.
   *
   * @param grid inflated; from a source that is not free nothing can be reached
   */
  public DistanceField(OccupancyGrid grid, Cell source) {
    this.grid = grid;
    lengths = new float[grid.width() * grid.height()];
    Arrays.fill(lengths, UNREACHABLE);
    if (grid.isFree(source)) {
      fill(grid.index(source));
    }
  }

  private void fill(int source) {
    MoveGraph graph = new MoveGraph(grid);
    OctileSearch search = new OctileSearch(graph);
    search.begin(graph, source, source);
    for (int cell = 0; cell < lengths.length; cell++) {
      int length = search.distance(cell);
      if (length != OctileSearch.UNREACHABLE) {
        lengths[cell] = (float) length / MoveCost.STRAIGHT;
      }
    }
  }

  /** The length of the shortest path, in cells; infinite where there is no path. */
  public double to(Cell cell) {
    return grid.contains(cell) ? lengths[grid.index(cell)] : UNREACHABLE;
  }
}
