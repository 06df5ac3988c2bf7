package org.toqa.grid;

import java.util.Arrays;
import java.util.BitSet;
import org.toqa.geometry.Vec2;

/**
 * Grows the obstacles by a robot's radius, so that a planner may treat the robot as a point (the
 * configuration space of a disc: Lozano-Perez, "Spatial planning", 1983).
 *
 * <p>The rule: a cell is blocked when an open disc of the radius round its centre overlaps the
 * square of an occupied cell or leaves the grid. A disc that merely touches a wall fits, so a robot
 * passes an aisle exactly as wide as itself; straight and corner-respecting diagonal moves between
 * free centres then keep the whole disc off the walls.
 *
 * <p>Along each row the distance to the nearest occupied cell is found once; a cell is then blocked
 * if in some row within the radius that distance is within the disc's reach in that row. Cost:
 * cells times rows in the disc, exact.
 */
public final class Inflation {
  /** In cells: far below what a map can mean, far above what rounding does to a radius. */
  private static final double ROUNDING = 1e-9;

  private Inflation() {}

  /**
   * The grid in which each cell is blocked where a disc's middle cannot be.
   *
   * @param radius metres, at least 0; 0 leaves the grid as it is
   * @throws IllegalArgumentException if it is below 0 or not finite
   */
  public static OccupancyGrid inflate(OccupancyGrid grid, double radius) {
    if (!(radius >= 0) || Double.isInfinite(radius)) {
      throw new IllegalArgumentException(
          "A margin is a number of metres from 0 up, not " + radius + ".");
    }
    int width = grid.width();
    int height = grid.height();
    double cells = radius / grid.resolution() - ROUNDING;
    int rows = cells <= 0 ? -1 : (int) Math.min(height, Math.ceil(cells - 0.5));
    if (rows < 0) {
      return grid;
    }
    int[] gap = rowGaps(grid);
    boolean[] touched = new boolean[gap.length];
    for (int dRow = -rows; dRow <= rows; dRow++) {
      int reach = reach(cells, dRow);
      int first = Math.max(0, -dRow) * width;
      int end = Math.min(height, height - dRow) * width;
      int shift = dRow * width;
      for (int i = first; i < end; i++) {
        touched[i] |= gap[i + shift] <= reach;
      }
    }
    BitSet blocked = new BitSet(touched.length);
    for (int i = 0; i < touched.length; i++) {
      blocked.set(i, touched[i]);
    }
    blockBorder(blocked, width, height, cells);
    return grid.withOccupied(blocked);
  }

  /**
   * Blocks only the cells in which the disc fits nowhere: neither in the middle nor on an edge's
   * middle or a corner. So an aisle two cells wide has a path for whatever fits in it, which drives
   * between the middles of its cells.
   *
   * @param radius metres, above 0
   * @throws IllegalArgumentException if it is not positive and finite
   */
  public static OccupancyGrid inflateWhereNothingFits(OccupancyGrid grid, double radius) {
    OccupancyGrid inMiddle = inflate(grid, radius);
    OccupancyGrid hopeless =
        inflate(grid, Math.max(0, radius - grid.resolution() * Math.sqrt(0.5)));
    Disc disc = new Disc(radius);
    BitSet blocked = inMiddle.occupied();
    for (int i = blocked.nextSetBit(0); i >= 0; i = blocked.nextSetBit(i + 1)) {
      if (hopeless.isFree(grid.cell(i)) && isFreeBesideCentre(grid, grid.cell(i), disc)) {
        blocked.clear(i);
      }
    }
    return grid.withOccupied(blocked);
  }

  private static boolean isFreeBesideCentre(OccupancyGrid grid, Cell cell, Disc disc) {
    Vec2 middle = grid.centre(cell);
    double half = grid.resolution() / 2;
    for (int row = -1; row <= 1; row++) {
      for (int column = -1; column <= 1; column++) {
        if (disc.isFreeAt(grid, middle.plus(new Vec2(column, row).times(half)))) {
          return true;
        }
      }
    }
    return false;
  }

  /** Columns from each cell to the nearest occupied one in its row. */
  private static int[] rowGaps(OccupancyGrid grid) {
    int width = grid.width();
    int[] gap = new int[width * grid.height()];
    Arrays.fill(gap, Integer.MAX_VALUE);
    for (int row = 0; row < grid.height(); row++) {
      int last = -1;
      for (int column = 0; column < width; column++) {
        last = grid.isFree(column, row) ? last : column;
        if (last >= 0) {
          gap[row * width + column] = column - last;
        }
      }
      int next = -1;
      for (int column = width - 1; column >= 0; column--) {
        next = grid.isFree(column, row) ? next : column;
        if (next >= 0) {
          gap[row * width + column] = Math.min(gap[row * width + column], next - column);
        }
      }
    }
    return gap;
  }

  /**
   * How many columns away an occupied square, {@code dRow} rows away, still overlaps the disc.
   *
   * @param radius in cells, positive
   */
  private static int reach(double radius, int dRow) {
    double dy = Math.max(0, Math.abs(dRow) - 0.5);
    double dx = Math.sqrt(radius * radius - dy * dy);
    return (int) Math.min(Integer.MAX_VALUE - 1, Math.ceil(dx + 0.5) - 1);
  }

  private static void blockBorder(BitSet blocked, int width, int height, double radius) {
    int border = (int) Math.min(Math.max(width, height), Math.ceil(radius - 0.5));
    for (int row = 0; row < height; row++) {
      if (row < border || row >= height - border) {
        blocked.set(row * width, (row + 1) * width);
      } else {
        blocked.set(row * width, row * width + Math.min(width, border));
        blocked.set(row * width + Math.max(0, width - border), (row + 1) * width);
      }
    }
  }
}
