package org.toqa.planning.smooth;

import java.util.BitSet;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.JumpPointSearch;
import org.toqa.planning.Path;
import org.toqa.planning.PlanResult;
import org.toqa.planning.SearchLimit;
import org.toqa.planning.SearchLimit.SearchTimeoutException;

/**
 * First paths: points of a lattice at which the disc may be, laid out as a grid, on which jump
 * points lead from start to goal. Each move between neighbouring points is free. It is not the
 * shortest path, nor always on the shortest side of an obstacle; tree and swarm shorten it.
 *
 * <p>Passages between squares of a grid are narrowest where both coordinates are multiples of half
 * a cell, so a lattice of half cells goes through aisles that just fit; where the disc is no wider
 * than a cell, the middles of the cells are enough. Laying out costs the points, and for each row
 * of a wall's edge the rows within the radius.
 */
final class Lattice {
  /** A lattice of more points is not laid out; they take about 14 B each. */
  private static final long MOST_POINTS = 1 << 23;

  /** How many lattice points around start and goal are tried, on each side. */
  private static final int AROUND = 3;

  private final DiscSpace space;

  /** Each cell stands for the point in its middle, in cells of the space. */
  private final @Nullable OccupancyGrid points;

  private final JumpPointSearch search = new JumpPointSearch();

  /**
   * @param space whose walls are known
   */
  Lattice(DiscSpace space) {
    this.space = space;
    this.points = space.radiusInCells() <= 0.5 ? middles(space) : halves(space);
  }

  private static OccupancyGrid middles(DiscSpace space) {
    BitSet occupied = space.grid().occupied();
    return new OccupancyGrid(space.width(), space.height(), 1, Vec2.ZERO, occupied);
  }

  private static @Nullable OccupancyGrid halves(DiscSpace space) {
    int columns = 2 * space.width() + 1;
    int rows = 2 * space.height() + 1;
    if ((long) columns * rows > MOST_POINTS) {
      return null;
    }
    BitSet blocked = new BitSet(columns * rows);
    new Halves(space, columns, rows, blocked).block();
    return new OccupancyGrid(columns, rows, 0.5, new Vec2(-0.25, -0.25), blocked);
  }

  /** Blocks the points of a lattice of half cells that are too near to a wall. */
  private record Halves(DiscSpace space, int columns, int rows, BitSet blocked) {

    void block() {
      double radius = space.radiusInCells();
      for (int row = 0; row < rows; row++) {
        if (row / 2.0 < radius || (rows - 1 - row) / 2.0 < radius) {
          block(row, 0, space.width());
        } else {
          block(row, Double.NEGATIVE_INFINITY, radius);
          block(row, space.width() - radius, Double.POSITIVE_INFINITY);
        }
      }
      for (int row = 0; row < space.height(); row++) {
        for (int begin = 0; begin < space.width(); begin++) {
          if (space.isOccupied(begin, row)) {
            int end = begin + 1;
            while (end < space.width() && space.isOccupied(end, row)) {
              end++;
            }
            blockAround(begin, end, row);
            begin = end;
          }
        }
      }
    }

    /** Blocks what is near to squares that stand side by side in a row. */
    private void blockAround(int begin, int end, int row) {
      double radius = space.radiusInCells();
      for (int at = 2 * row; at <= 2 * row + 2; at++) {
        block(at, begin - radius, end + radius);
      }
      int reach = (int) Math.ceil(2 * radius) - 1;
      // what is behind squares that are all occupied is near to these as well
      int down = isOccupied(begin, end, row - 1) ? 0 : Math.min(reach, 2 * row);
      int up = isOccupied(begin, end, row + 1) ? 0 : Math.min(reach, rows - 3 - 2 * row);
      for (int step = 1; step <= Math.max(down, up); step++) {
        // beside a corner, the line between two points is nearer to it than they are:
        // its middle by R - r at most, R^2 = r^2 + (half of the diagonal move)^2
        double beside = Math.sqrt(radius * radius + 0.125 - step * step / 4.0);
        if (step <= down) {
          block(2 * row - step, begin - beside, end + beside);
        }
        if (step <= up) {
          block(2 * row + 2 + step, begin - beside, end + beside);
        }
      }
    }

    private boolean isOccupied(int begin, int end, int row) {
      for (int column = begin; column < end; column++) {
        if (!space.isOccupied(column, row)) {
          return false;
        }
      }
      return true;
    }

    /** Blocks the points of a row between two places, but not these themselves; cells. */
    private void block(int row, double from, double to) {
      int first = (int) Math.max(0, Math.floor(2 * from) + 1);
      int last = (int) Math.min(columns - 1, Math.ceil(2 * to) - 1);
      if (first <= last) {
        int begin = (rows - 1 - row) * columns;
        blocked.set(begin + first, begin + last + 1);
      }
    }
  }

  /**
   * A free path; null where the lattice has none, or time is over.
   *
   * @param ends start and goal
   */
  @Nullable WayPoints path(WayPoints ends, BooleanSupplier isOver) {
    Cell start = points == null ? null : beside(points, ends.x(0), ends.y(0));
    Cell goal = points == null ? null : beside(points, ends.x(1), ends.y(1));
    if (points == null || start == null || goal == null) {
      return null;
    }
    try {
      PlanResult result = SearchLimit.within(isOver, () -> search.plan(points, start, goal));
      return result instanceof PlanResult.Found(Path path) ? through(ends, start, path) : null;
    } catch (SearchTimeoutException _) {
      return null;
    }
  }

  /** The nearest point of the lattice to which a free line leads; null for none. */
  private @Nullable Cell beside(OccupancyGrid lattice, double x, double y) {
    Vec2 end = new Vec2(x, y);
    return lattice.cellsAround(end, AROUND).stream()
        .filter(lattice::isFree)
        .filter(cell -> isFree(end, lattice.centre(cell)))
        .findFirst()
        .orElse(null);
  }

  private boolean isFree(Vec2 from, Vec2 to) {
    return space.isFree(from.x(), from.y(), to.x(), to.y());
  }

  private WayPoints through(WayPoints ends, Cell start, Path found) {
    OccupancyGrid lattice = Objects.requireNonNull(points);
    Vec2 first = lattice.centre(start);
    WayPoints path = new WayPoints().add(ends.x(0), ends.y(0)).add(first.x(), first.y());
    for (Waypoint bend : found.waypoints(lattice)) {
      path.add(bend.position().x(), bend.position().y());
    }
    return path.add(ends.x(1), ends.y(1));
  }
}
