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
}
