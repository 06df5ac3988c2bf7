package org.toqa.grid;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * A robot's outline on the floor. A cell is touched when its square and the open disc overlap, the
 * same rule as in {@link Inflation}.
 *
 * @param radius metres, positive
 */
public record Disc(double radius) {
  private static final double ROUNDING = 1e-9;

  /**
   * @throws IllegalArgumentException if it is not positive and finite
   */
  public Disc {
    if (!(radius > 0) || Double.isInfinite(radius)) {
      throw new IllegalArgumentException("A disc has a positive radius, not " + radius + " m.");
    }
  }

  /**
   * The cells of the grid that the disc touches when its centre is at a point.
   *
   * @param centre metres, map frame
   */
  public List<Cell> cellsAt(OccupancyGrid grid, Vec2 centre) {
    return cellsAlong(grid, centre, centre);
  }

  /**
   * The cells of the grid that the disc touches while its centre moves along a straight line. For
   * an arc, take its chord and a disc larger by the arc's height over the chord.
   *
   * @param from metres, map frame
   * @param to metres, map frame
   */
  public List<Cell> cellsAlong(OccupancyGrid grid, Vec2 from, Vec2 to) {
    Cell upperLeft =
        grid.cellAt(
            new Vec2(Math.min(from.x(), to.x()) - radius, Math.max(from.y(), to.y()) + radius));
    Cell lowerRight =
        grid.cellAt(
            new Vec2(Math.max(from.x(), to.x()) + radius, Math.min(from.y(), to.y()) - radius));
    List<Cell> touched = new ArrayList<>();
    int lastRow = Math.min(grid.height() - 1, lowerRight.row());
    int lastColumn = Math.min(grid.width() - 1, lowerRight.column());
    for (int row = Math.max(0, upperLeft.row()); row <= lastRow; row++) {
      for (int column = Math.max(0, upperLeft.column()); column <= lastColumn; column++) {
        Cell cell = new Cell(column, row);
        Vec2 centre = grid.centre(cell);
        double half = grid.resolution() / 2;
        double limit = radius - ROUNDING * grid.resolution();
        double toCentre = centre.distanceToLine(from, to);
        if (toCentre < limit
            || (toCentre < limit + 2 * half
                && distanceToSquare(from.minus(centre), to.minus(centre), half) < limit)) {
          touched.add(cell);
        }
      }
    }
    return touched;
  }

  /**
   * Whether the disc, standing at a point, overlaps no occupied cell and stays on the grid.
   *
   * @param centre metres, map frame
   */
  public boolean isFreeAt(OccupancyGrid grid, Vec2 centre) {
    Vec2 upperRight =
        grid.origin().plus(new Vec2(grid.width(), grid.height()).times(grid.resolution()));
    double toBorder =
        Math.min(
            Math.min(centre.x() - grid.origin().x(), upperRight.x() - centre.x()),
            Math.min(centre.y() - grid.origin().y(), upperRight.y() - centre.y()));
    return toBorder >= radius - ROUNDING * grid.resolution()
        && cellsAt(grid, centre).stream().allMatch(grid::isFree);
  }

  /** Metres between a point, map frame, and a cell of the grid; 0 inside. */
  public static double distanceToCell(OccupancyGrid grid, Vec2 point, Cell cell) {
    return pointToSquare(point.minus(grid.centre(cell)), grid.resolution() / 2);
  }

  /** From the line a-b to the square round the origin with half side {@code half}; 0 inside. */
  private static double distanceToSquare(Vec2 a, Vec2 b, double half) {
    if (crossesSquare(a, b, half)) {
      return 0;
    }
    double nearest = Math.min(pointToSquare(a, half), pointToSquare(b, half));
    for (int corner = 0; corner < 4; corner++) {
      Vec2 p = new Vec2((corner & 1) == 0 ? -half : half, (corner & 2) == 0 ? -half : half);
      nearest = Math.min(nearest, p.distanceToLine(a, b));
    }
    return nearest;
  }

  private static double pointToSquare(Vec2 p, double half) {
    double east = Math.max(0, Math.abs(p.x()) - half);
    double north = Math.max(0, Math.abs(p.y()) - half);
    return Math.sqrt(east * east + north * north);
  }

  // Clips the line's parameter to both slabs of the square (Liang and Barsky, 1984).
  private static boolean crossesSquare(Vec2 a, Vec2 b, double half) {
    double enter = 0;
    double leave = 1;
    double[] start = {a.x(), a.y()};
    double[] step = {b.x() - a.x(), b.y() - a.y()};
    for (int axis = 0; axis < 2; axis++) {
      if (step[axis] == 0) {
        if (Math.abs(start[axis]) > half) {
          return false;
        }
      } else {
        double t0 = (-half - start[axis]) / step[axis];
        double t1 = (half - start[axis]) / step[axis];
        enter = Math.max(enter, Math.min(t0, t1));
        leave = Math.min(leave, Math.max(t0, t1));
      }
    }
    return enter <= leave;
  }
}
