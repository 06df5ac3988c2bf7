package org.toqa.planning.exact;

import org.toqa.grid.OccupancyGrid;

/**
 * The walls of a grid as rectangles, one for each run of occupied squares in a row, and what they
 * leave free for a disc. A rectangle grown by a radius is the union of two rectangles and four
 * discs (Minkowski's sum); a centre's line is free if it meets the inside of none of these.
 *
 * <p>Cells, from the grid's lower left corner; the outside is wall.
 */
final class WallRuns {
  /** Cells by which a disc may overlap a wall: rounding. */
  static final double TOLERANCE = 1e-9;

  private final int width;
  private final int height;
  private final double radius;
  private final boolean[] wall;

  /** By cell: the column after the end of the run of its own kind, wall or free, to the east. */
  private final int[] runEnd;

  /**
   * @param radius cells
   */
  WallRuns(OccupancyGrid grid, double radius) {
    width = grid.width();
    height = grid.height();
    this.radius = radius - Math.min(TOLERANCE, radius / 2);
    wall = new boolean[width * height];
    runEnd = new int[width * height];
    for (int row = 0; row < height; row++) {
      for (int column = width - 1; column >= 0; column--) {
        int index = row * width + column;
        wall[index] = !grid.isFree(column, height - 1 - row);
        boolean goesOn = column + 1 < width && wall[index + 1] == wall[index];
        runEnd[index] = goesOn ? runEnd[index + 1] : column + 1;
      }
    }
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /** True outside the grid. */
  boolean isWall(int column, int row) {
    return column < 0 || row < 0 || column >= width || row >= height || wall[row * width + column];
  }

  boolean isFree(double x, double y) {
    return isFree(x, y, x, y);
  }

  /** Whether the disc's centre may go along a line. */
  boolean isFree(double x0, double y0, double x1, double y1) {
    double least = Math.min(Math.min(x0, x1), Math.min(y0, y1));
    if (least < radius || Math.max(x0, x1) > width - radius || Math.max(y0, y1) > height - radius) {
      return false;
    }
    int first = row(Math.min(y0, y1) - radius);
    int last = row(Math.max(y0, y1) + radius);
    // from the line's beginning: what blocks it is mostly near there
    boolean upward = y1 >= y0;
    for (int i = 0; i <= last - first; i++) {
      int row = upward ? first + i : last - i;
      if (!isFreeOfRow(row, x0, y0, x1, y1)) {
        return false;
      }
    }
    return true;
  }

  private int row(double y) {
    return (int) Math.clamp(Math.floor(y), 0, height - 1.0);
  }

  private int column(double x) {
    return (int) Math.clamp(Math.floor(x), 0, width - 1.0);
  }

  private boolean isFreeOfRow(int row, double x0, double y0, double x1, double y1) {
    double enter = 0;
    double leave = 1;
    if (y0 != y1) {
      double t0 = (row - radius - y0) / (y1 - y0);
      double t1 = (row + 1 + radius - y0) / (y1 - y0);
      enter = Math.clamp(Math.min(t0, t1), 0, 1);
      leave = Math.clamp(Math.max(t0, t1), 0, 1);
    }
    double from = x0 + enter * (x1 - x0);
    double to = x0 + leave * (x1 - x0);
    int end = column(Math.max(from, to) + radius);
    for (int column = column(Math.min(from, to) - radius); column <= end; ) {
      int index = row * width + column;
      if (wall[index] && meets(column, row, runEnd[index], row + 1, x0, y0, x1, y1)) {
        return false;
      }
      column = runEnd[index];
    }
    return true;
  }

  /** Whether a line meets the inside of a grown rectangle. */
  private boolean meets(
      double left,
      double bottom,
      double right,
      double top,
      double x0,
      double y0,
      double x1,
      double y1) {
    return meetsBox(left - radius, bottom, right + radius, top, x0, y0, x1, y1)
        || meetsBox(left, bottom - radius, right, top + radius, x0, y0, x1, y1)
        || meetsDisc(left, bottom, x0, y0, x1, y1)
        || meetsDisc(right, bottom, x0, y0, x1, y1)
        || meetsDisc(left, top, x0, y0, x1, y1)
        || meetsDisc(right, top, x0, y0, x1, y1);
  }

  // clips the line's parameter to both slabs of the box (Liang and Barsky, 1984)
  private static boolean meetsBox(
      double left,
      double bottom,
      double right,
      double top,
      double x0,
      double y0,
      double x1,
      double y1) {
    Span inside = Span.within(left, right, x0, x1).and(Span.within(bottom, top, y0, y1));
    boolean isPoint = x0 == x1 && y0 == y1;
    return isPoint ? inside.enter() <= inside.leave() : inside.enter() < inside.leave();
  }

  /** From where to where a line is in a slab, of its parameter from 0 to 1; empty: never. */
  private record Span(double enter, double leave) {
    private static final Span WHOLE = new Span(0, 1);
    private static final Span NEVER = new Span(1, 0);

    static Span within(double low, double high, double begin, double end) {
      if (begin == end) {
        return begin > low && begin < high ? WHOLE : NEVER;
      }
      double a = (low - begin) / (end - begin);
      double b = (high - begin) / (end - begin);
      return WHOLE.and(new Span(Math.min(a, b), Math.max(a, b)));
    }

    Span and(Span other) {
      return new Span(Math.max(enter, other.enter), Math.min(leave, other.leave));
    }
  }

  private boolean meetsDisc(double x, double y, double x0, double y0, double x1, double y1) {
    double dx = x1 - x0;
    double dy = y1 - y0;
    double squared = dx * dx + dy * dy;
    double t = squared == 0 ? 0 : Math.clamp(((x - x0) * dx + (y - y0) * dy) / squared, 0, 1);
    double east = x0 + t * dx - x;
    double north = y0 + t * dy - y;
    return east * east + north * north < radius * radius;
  }
}
