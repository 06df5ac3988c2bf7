package org.toqa.planning.smooth;

import java.util.concurrent.atomic.AtomicReferenceArray;
import org.toqa.grid.OccupancyGrid;

/**
 * For each free cell of a grid the few occupied squares of which one is the nearest to whatever
 * point of the cell, up to a horizon. Outside the grid all is occupied.
 *
 * <p>Of a row above the cell only the nearest occupied square to the west and to the east can be
 * nearest, and only if no row between has one as near in columns; and none above the first square
 * over the cell itself. So the squares are read off the rows' gaps, from the cell outward, until a
 * row is beyond the horizon: the same thought as in the exact distance transform of Felzenszwalb
 * and Huttenlocher ("Distance transforms of sampled functions", 2012), but for every point of a
 * cell. Cost: rows within the horizon, once for each cell that is asked about.
 */
final class NearbySquares {
  /** What {@link #of} answers for an occupied cell, or one outside the grid. */
  static final int[] OCCUPIED = {};

  private static final int[] NONE = {};

  /** No gap is told longer; horizons are shorter. */
  private static final int LONGEST_GAP = Character.MAX_VALUE;

  private final int width;
  private final int height;
  private final double horizon;

  /** Free cells between a cell and the nearest occupied one to the west, row 0 at the bottom. */
  private final char[] west;

  private final char[] east;
  private final boolean[] occupied;
  private final AtomicReferenceArray<int[]> squares;

  /**
   * @param horizon cells; squares that are farther from a cell are left out
   */
  NearbySquares(OccupancyGrid grid, double horizon) {
    this.width = grid.width();
    this.height = grid.height();
    this.horizon = horizon;
    this.west = new char[width * height];
    this.east = new char[width * height];
    this.occupied = new boolean[width * height];
    this.squares = new AtomicReferenceArray<>(width * height);
    for (int row = 0; row < height; row++) {
      measureGaps(grid, row);
    }
  }

  private void measureGaps(OccupancyGrid grid, int row) {
    int first = row * width;
    int gap = 0;
    for (int column = 0; column < width; column++) {
      boolean isWall = !grid.isFree(column, height - 1 - row);
      occupied[first + column] = isWall;
      west[first + column] = (char) Math.min(gap, LONGEST_GAP);
      gap = isWall ? 0 : gap + 1;
    }
    gap = 0;
    for (int column = width - 1; column >= 0; column--) {
      east[first + column] = (char) Math.min(gap, LONGEST_GAP);
      gap = occupied[first + column] ? 0 : gap + 1;
    }
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /** True outside the grid. */
  boolean isOccupied(int column, int row) {
    return column < 0
        || row < 0
        || column >= width
        || row >= height
        || occupied[row * width + column];
  }

  /**
   * The squares by turns with their column and row: the lower left corners, in cells.
   *
   * @param row 0 at the bottom
   * @return {@link #OCCUPIED} for an occupied cell; not to be changed
   */
  int[] of(int column, int row) {
    if (isOccupied(column, row)) {
      return OCCUPIED;
    }
    int index = row * width + column;
    int[] known = squares.getAcquire(index);
    if (known == null) {
      known = new Collector(column, row).collect();
      squares.setRelease(index, known);
    }
    return known;
  }

  /** Collects the squares near one cell. */
  private final class Collector {
    private final int column;
    private final int row;
    private int[] found = new int[16];
    private int count;

    /** Cells; the largest distance from a point of the cell to the nearest square so far. */
    private double farthest = Double.POSITIVE_INFINITY;

    Collector(int column, int row) {
      this.column = column;
      this.row = row;
    }

    int[] collect() {
      int westGap = west[row * width + column];
      int eastGap = east[row * width + column];
      add(column - westGap - 1, row);
      add(column + eastGap + 1, row);
      look(1, westGap, eastGap);
      look(-1, westGap, eastGap);
      return withoutFarOnes();
    }

    /** Looks at the rows above or below, from the cell outward. */
    private void look(int step, int westOfRow, int eastOfRow) {
      int westGap = westOfRow;
      int eastGap = eastOfRow;
      // rows beyond the nearest square so far have none that is nearer
      for (int distance = 1; distance - 1 <= Math.min(horizon, farthest); distance++) {
        int other = row + step * distance;
        if (isOccupied(column, other)) {
          add(column, other);
          return;
        }
        int index = other * width + column;
        if (west[index] < westGap) {
          westGap = west[index];
          add(column - westGap - 1, other);
        }
        if (east[index] < eastGap) {
          eastGap = east[index];
          add(column + eastGap + 1, other);
        }
      }
    }

    private void add(int squareColumn, int squareRow) {
      double least = gapBetween(squareColumn, squareRow);
      if (least > Math.min(horizon, farthest)) {
        return;
      }
      if (count + 2 > found.length) {
        found = java.util.Arrays.copyOf(found, 2 * found.length);
      }
      found[count++] = squareColumn;
      found[count++] = squareRow;
      double across = Math.abs(squareColumn - column);
      double up = Math.abs(squareRow - row);
      farthest = Math.min(farthest, Math.sqrt(across * across + up * up));
    }

    /** Cells between the nearest points of the cell and a square. */
    private double gapBetween(int squareColumn, int squareRow) {
      double across = Math.max(0, Math.abs(squareColumn - column) - 1);
      double up = Math.max(0, Math.abs(squareRow - row) - 1);
      return Math.sqrt(across * across + up * up);
    }

    private int[] withoutFarOnes() {
      int kept = 0;
      for (int i = 0; i < count; i += 2) {
        if (gapBetween(found[i], found[i + 1]) <= farthest) {
          found[kept] = found[i];
          found[kept + 1] = found[i + 1];
          kept += 2;
        }
      }
      return kept == 0 ? NONE : java.util.Arrays.copyOf(found, kept);
    }
  }
}
