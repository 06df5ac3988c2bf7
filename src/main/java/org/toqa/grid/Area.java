package org.toqa.grid;

import java.util.BitSet;
import org.toqa.geometry.Vec2;

/**
 * A rectangle along the axes of the map frame.
 *
 * @param low its lower left corner, metres
 * @param width metres to the east, above 0
 * @param height metres to the north, above 0
 */
public record Area(Vec2 low, double width, double height) {
  public Area {
    if (!(width > 0 && height > 0)) {
      throw new IllegalArgumentException("an area of " + width + " m by " + height + " m");
    }
  }

  /** Its upper right corner, metres. */
  public Vec2 high() {
    return low.plus(new Vec2(width, height));
  }

  /**
   * The cells of the grid that it overlaps, by {@link OccupancyGrid#index}. Where it ends on a
   * cell's border it does not reach into the next cell.
   */
  public BitSet cells(OccupancyGrid grid) {
    double rounding = grid.resolution() * 1e-6;
    Vec2 inset = new Vec2(rounding, rounding);
    Cell first = grid.cellAt(low.plus(inset));
    Cell last = grid.cellAt(high().minus(inset));
    BitSet cells = new BitSet();
    int from = Math.clamp(first.column(), 0, grid.width());
    int to = Math.clamp(last.column() + 1L, from, grid.width());
    for (int row = Math.max(0, last.row()); row <= first.row() && row < grid.height(); row++) {
      cells.set(row * grid.width() + from, row * grid.width() + to);
    }
    return cells;
  }

  /** Whether a point is in it, metres. */
  public boolean contains(Vec2 point) {
    return contains(point, 0);
  }

  /** Whether they have more than a border in common. */
  public boolean overlaps(Area other) {
    return low.x() < other.high().x()
        && other.low.x() < high().x()
        && low.y() < other.high().y()
        && other.low.y() < high().y();
  }

  /** Whether a point is in it and so far from its border, metres. */
  boolean contains(Vec2 point, double inset) {
    return point.x() > low.x() + inset
        && point.x() < low.x() + width - inset
        && point.y() > low.y() + inset
        && point.y() < low.y() + height - inset;
  }

  /** What part of a straight lies so far within its border, metres; from 0 to 1. */
  double shareInside(Vec2 from, Vec2 to, double inset) {
    return Math.max(0, leave(from, to, inset) - enter(from, to, inset));
  }

  /**
   * What share of a straight lies before it comes so far within the border; after {@link #leave}:
   * it does not. The line's parameter is clipped to both slabs (Liang and Barsky, 1984).
   */
  double enter(Vec2 from, Vec2 to, double inset) {
    return Math.max(
        0,
        Math.max(
            enter(from.x(), to.x(), low.x() + inset, low.x() + width - inset),
            enter(from.y(), to.y(), low.y() + inset, low.y() + height - inset)));
  }

  /** What share of a straight lies before it is no longer so far within the border. */
  double leave(Vec2 from, Vec2 to, double inset) {
    return Math.min(
        1,
        Math.min(
            -enter(from.x(), to.x(), low.x() + inset, low.x() + width - inset, -1),
            -enter(from.y(), to.y(), low.y() + inset, low.y() + height - inset, -1)));
  }

  private static double enter(double from, double to, double least, double most) {
    return enter(from, to, least, most, 1);
  }

  /**
   * @param sign 1: where the slab is entered; -1: where it is left, with the sign changed
   */
  private static double enter(double from, double to, double least, double most, int sign) {
    double way = to - from;
    if (way == 0) {
      return from >= least && from <= most ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    }
    boolean isLow = way > 0 == (sign > 0);
    return sign * ((isLow ? least : most) - from) / way;
  }
}
