package org.toqa.grid;

import org.toqa.geometry.Vec2;

/**
 * How far one sees on a grid. The ray goes from cell to cell in the order in which it meets their
 * borders, so it costs one step a cell and misses none (Amanatides and Woo, 1987).
 */
public final class RayCast {

  private RayCast() {}

  /**
   * Metres from a point to the first cell that is not free; what lies outside the grid is not.
   *
   * @param from metres, map frame
   * @param direction radians, counter-clockwise from map east
   * @param farthest metres, at least 0; the answer where nothing is nearer
   */
  public static double distance(OccupancyGrid grid, Vec2 from, double direction, double farthest) {
    double side = grid.resolution();
    double x = (from.x() - grid.origin().x()) / side;
    double y = (from.y() - grid.origin().y()) / side;
    int column = (int) Math.floor(x);
    int up = (int) Math.floor(y);
    double dx = Math.cos(direction);
    double dy = Math.sin(direction);
    double toColumn = untilBorder(x - column, dx);
    double toRow = untilBorder(y - up, dy);
    double travelled = 0; // in cells
    while (travelled * side < farthest) {
      if (!grid.isFree(column, grid.height() - 1 - up)) {
        return travelled * side;
      }
      if (toColumn < toRow) {
        travelled = toColumn;
        toColumn += Math.abs(1 / dx);
        column += dx > 0 ? 1 : -1;
      } else {
        travelled = toRow;
        toRow += Math.abs(1 / dy);
        up += dy > 0 ? 1 : -1;
      }
    }
    return farthest;
  }

  /** Told each cell along a ray. */
  @FunctionalInterface
  public interface CellVisitor {
    /**
     * @param column of the cell, from the west
     * @param up its row, from the south
     * @param entered metres along the ray
     * @param left metres along the ray
     * @return whether the ray goes on
     */
    boolean visit(int column, int up, double entered, double left);
  }

  /**
   * Goes along a ray through squares without end, in the order in which it meets them.
   *
   * @param side metres of a square
   * @param from metres from the lower left corner of the square in column 0 and the lowest row
   * @param direction radians, counter-clockwise from map east
   * @param farthest metres: the last square is that in which the ray is then
   */
  public static void walk(
      double side, Vec2 from, double direction, double farthest, CellVisitor visitor) {
    double x = from.x() / side;
    double y = from.y() / side;
    int column = (int) Math.floor(x);
    int up = (int) Math.floor(y);
    double dx = Math.cos(direction);
    double dy = Math.sin(direction);
    double toColumn = untilBorder(x - column, dx);
    double toRow = untilBorder(y - up, dy);
    double travelled = 0; // in squares
    while (travelled * side < farthest) {
      double next = Math.min(toColumn, toRow);
      if (!visitor.visit(column, up, travelled * side, next * side)) {
        return;
      }
      travelled = next;
      if (toColumn < toRow) {
        toColumn += Math.abs(1 / dx);
        column += dx > 0 ? 1 : -1;
      } else {
        toRow += Math.abs(1 / dy);
        up += dy > 0 ? 1 : -1;
      }
    }
  }

  /** How far along the ray the cell's border is, in cells. */
  private static double untilBorder(double inside, double step) {
    if (step == 0) {
      return Double.POSITIVE_INFINITY;
    }
    return step > 0 ? (1 - inside) / step : inside / -step;
  }
}
