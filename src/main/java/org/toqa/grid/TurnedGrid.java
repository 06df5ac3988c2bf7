package org.toqa.grid;

import java.util.BitSet;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.geometry.Vec2;

/** A grid that lies turned in the map frame, as the origin of a ROS map may say. */
final class TurnedGrid {
  /** In cells: those that overlap by less only touch. */
  private static final double ROUNDING = 1e-6;

  private TurnedGrid() {}

  /**
   * The same floor in cells along the axes of the map frame. A cell is free where it overlaps only
   * free cells of the picture: walls grow by a cell's diagonal at most, and never shrink.
   *
   * @param file of the map, for what is said of a floor that becomes too large
   * @param grid as if it was not turned
   * @param angle by which it is turned round its origin, radians counter-clockwise
   */
  static OccupancyGrid turn(MapFile file, OccupancyGrid grid, double angle)
      throws MapFormatException {
    if (angle == 0) {
      return grid;
    }
    double side = grid.resolution();
    Vec2 size = new Vec2(grid.width(), grid.height());
    List<Vec2> corners =
        Stream.of(Vec2.ZERO, new Vec2(size.x(), 0), new Vec2(0, size.y()), size)
            .map(corner -> corner.rotated(angle))
            .toList();
    Vec2 low =
        new Vec2(
            corners.stream().mapToDouble(Vec2::x).min().orElseThrow(),
            corners.stream().mapToDouble(Vec2::y).min().orElseThrow());
    int width = cells(corners.stream().mapToDouble(Vec2::x).max().orElseThrow() - low.x());
    int height = cells(corners.stream().mapToDouble(Vec2::y).max().orElseThrow() - low.y());
    MapLimits.checkSize(file, width, height);
    BitSet occupied = new BitSet(width * height);
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        Vec2 middle = low.plus(new Vec2(column + 0.5, height - row - 0.5));
        occupied.set(row * width + column, !isFree(grid, middle, angle));
      }
    }
    return new OccupancyGrid(width, height, side, grid.origin().plus(low.times(side)), occupied);
  }

  private static int cells(double length) {
    return (int) Math.ceil(length - ROUNDING);
  }

  /**
   * By the theorem of separating axes: two squares overlap where their projections on the sides of
   * both do.
   *
   * @param middle of a cell, in cells from the grid's origin, along the axes of the map frame
   */
  private static boolean isFree(OccupancyGrid grid, Vec2 middle, double angle) {
    Vec2 inGrid = middle.rotated(-angle);
    double reach = 0.5 + (Math.abs(Math.cos(angle)) + Math.abs(Math.sin(angle))) / 2 - ROUNDING;
    int firstColumn = (int) Math.floor(inGrid.x() - reach + 0.5);
    int firstUp = (int) Math.floor(inGrid.y() - reach + 0.5);
    for (int up = firstUp; up + 0.5 < inGrid.y() + reach; up++) {
      for (int column = firstColumn; column + 0.5 < inGrid.x() + reach; column++) {
        Vec2 apart = new Vec2(column + 0.5, up + 0.5).minus(inGrid);
        int row = grid.height() - 1 - up;
        if (isWithin(apart, reach)
            && isWithin(apart.rotated(angle), reach)
            && !(grid.contains(column, row) && grid.isFree(column, row))) {
          return false;
        }
      }
    }
    return true;
  }

  private static boolean isWithin(Vec2 apart, double reach) {
    return Math.max(Math.abs(apart.x()), Math.abs(apart.y())) < reach;
  }
}
