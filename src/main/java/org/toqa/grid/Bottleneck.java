package org.toqa.grid;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.toqa.geometry.Vec2;

/**
 * The narrowest place of the widest way between two points.
 *
 * <p>Points half a cell apart, which are the middles, corners and sides' middles of cells, are
 * joined to their neighbours in the order of their distance to the nearest wall, the farthest
 * first; the one that joins the two ends is the place (a maximum spanning tree, after Kruskal). The
 * nearest point of a wall to such a point is one of them too, so distances are exact up to the
 * limit. Cost: points times the limit in cells.
 *
 * @param place metres, map frame
 * @param width metres, between the walls beside it
 */
public record Bottleneck(Vec2 place, double width) {

  /**
   * @param from metres, map frame
   * @param to metres, map frame
   * @param limit width from which a place is no narrow one, metres; nor is one so near to an end
   * @return empty where a way is nowhere narrower than that, or there is none
   */
  public static Optional<Bottleneck> between(OccupancyGrid grid, Vec2 from, Vec2 to, double limit) {
    HalfCells points = new HalfCells(grid, limit / 2);
    int start = points.index(from);
    int end = points.index(to);
    points.open(start, limit);
    points.open(end, limit);
    int last = points.join(start, end);
    return last < 0 || points.gap[last] >= limit / 2 - 1e-9
        ? Optional.empty()
        : Optional.of(new Bottleneck(points.at(last), 2 * points.gap[last]));
  }

  private static final class HalfCells {
    private final OccupancyGrid grid;
    private final double step;
    private final int columns;
    private final int rows;

    /** Metres to the nearest wall, at most the limit. */
    private final double[] gap;

    private final int[] part;

    /** Metres. */
    private final double limit;

    HalfCells(OccupancyGrid grid, double limit) {
      this.grid = grid;
      this.limit = limit;
      this.step = grid.resolution() / 2;
      this.columns = 2 * grid.width() + 1;
      this.rows = 2 * grid.height() + 1;
      this.gap = gaps();
      this.part = new int[gap.length];
      Arrays.fill(part, -1);
    }

    private double[] gaps() {
      int reach = (int) Math.ceil(limit / step);
      int[] inRow = new int[columns * rows];
      for (int row = 0; row < rows; row++) {
        int since = reach;
        for (int column = 0; column < columns; column++) {
          since = isWall(column, row) ? 0 : Math.min(reach, since + 1);
          inRow[row * columns + column] = since;
        }
        since = reach;
        for (int column = columns - 1; column >= 0; column--) {
          int i = row * columns + column;
          since = inRow[i] == 0 ? 0 : Math.min(reach, since + 1);
          inRow[i] = Math.min(inRow[i], since);
        }
      }
      double[] gaps = new double[inRow.length];
      for (int row = 0; row < rows; row++) {
        int first = Math.max(0, row - reach);
        int end = Math.min(rows - 1, row + reach);
        for (int column = 0; column < columns; column++) {
          double least = limit / step;
          for (int r = first; r <= end; r++) {
            least = Math.min(least, Math.hypot(r - row, inRow[r * columns + column]));
          }
          gaps[row * columns + column] = least * step;
        }
      }
      return gaps;
    }

    /** Whether one of the cells that meet there is occupied, or off the grid. */
    private boolean isWall(int column, int row) {
      for (int r = (row - 1) >> 1; r <= row >> 1; r++) {
        for (int c = (column - 1) >> 1; c <= column >> 1; c++) {
          if (!grid.isFree(c, r)) {
            return true;
          }
        }
      }
      return false;
    }

    int index(Vec2 point) {
      Vec2 seen = point.minus(grid.origin()).times(1 / step);
      int column = Math.clamp(Math.round(seen.x()), 0, columns - 1);
      int row = Math.clamp(rows - 1 - Math.round(seen.y()), 0, rows - 1);
      return row * columns + column;
    }

    Vec2 at(int index) {
      Vec2 seen = new Vec2(index % columns, rows - 1 - index / columns);
      return grid.origin().plus(seen.times(step));
    }

    /** Lets no place count that is so near to an end: a wall beside that makes no passage. */
    void open(int end, double near) {
      Vec2 middle = at(end);
      BitSet seen = new BitSet();
      Deque<Integer> next = new ArrayDeque<>(List.of(end));
      while (!next.isEmpty()) {
        int i = next.remove();
        boolean isIn = gap[i] > 0 && at(i).distanceTo(middle) < near && !seen.get(i);
        if (isIn) {
          seen.set(i);
          int column = i % columns;
          if (column > 0) {
            next.add(i - 1);
          }
          if (column < columns - 1) {
            next.add(i + 1);
          }
          if (i >= columns) {
            next.add(i - columns);
          }
          if (i < gap.length - columns) {
            next.add(i + columns);
          }
        }
      }
      seen.stream().forEach(i -> gap[i] = Math.max(gap[i], limit));
    }

    /** The point by which both are joined; -1: nothing joins them. */
    int join(int start, int end) {
      int[] order =
          IntStream.range(0, gap.length)
              .filter(i -> gap[i] > 0)
              .boxed()
              .sorted(Comparator.comparingDouble(i -> -gap[i]))
              .mapToInt(i -> i)
              .toArray();
      for (int i : order) {
        part[i] = i;
        int column = i % columns;
        joinIf(column > 0, i, i - 1);
        joinIf(column < columns - 1, i, i + 1);
        joinIf(i >= columns, i, i - columns);
        joinIf(i < gap.length - columns, i, i + columns);
        if (part[start] >= 0 && part[end] >= 0 && root(start) == root(end)) {
          return i;
        }
      }
      return -1;
    }

    private void joinIf(boolean isThere, int one, int other) {
      if (isThere && part[other] >= 0) {
        part[root(one)] = root(other);
      }
    }

    private int root(int index) {
      int root = index;
      while (part[root] != root) {
        part[root] = part[part[root]];
        root = part[root];
      }
      return root;
    }
  }
}
