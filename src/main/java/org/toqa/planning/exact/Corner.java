package org.toqa.planning.exact;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A corner of a wall that a shortest path may go round: the disc's centre goes along a quarter of a
 * circle about it.
 *
 * @param x cells
 * @param y cells
 * @param begin angle of the quarter's first point, counter-clockwise from east, radians: 0, 90, 180
 *     or 270 degrees
 */
record Corner(double x, double y, double begin) {
  static final double QUARTER = Math.PI / 2;

  /** All of a grid: where just one of the four squares around a point is wall. */
  static List<Corner> of(WallRuns walls) {
    List<Corner> corners = new ArrayList<>();
    for (int y = 0; y <= walls.height(); y++) {
      for (int x = 0; x <= walls.width(); x++) {
        boolean northEast = walls.isWall(x, y);
        boolean northWest = walls.isWall(x - 1, y);
        boolean southWest = walls.isWall(x - 1, y - 1);
        boolean southEast = walls.isWall(x, y - 1);
        int count =
            (northEast ? 1 : 0) + (northWest ? 1 : 0) + (southWest ? 1 : 0) + (southEast ? 1 : 0);
        if (count == 1) {
          int quarter = southWest ? 0 : southEast ? 1 : northEast ? 2 : 3;
          corners.add(new Corner(x, y, quarter * QUARTER));
        }
      }
    }
    return corners;
  }

  /**
   * The parts of the quarter on which the disc is free of all other walls.
   *
   * @param radius cells
   * @return angles from {@code begin}, by turns where a free part begins and ends, ascending
   */
  double[] freeParts(WallRuns walls, double radius) {
    List<Double> borders = new ArrayList<>(List.of(0.0, QUARTER));
    int reach = (int) Math.ceil(2 * radius) + 1;
    for (int row = (int) y - reach; row < y + reach; row++) {
      for (int column = (int) x - reach; column < x + reach; column++) {
        boolean isWall = walls.isWall(column, row);
        if (isWall != walls.isWall(column - 1, row)) {
          addBorders(borders, column, row, radius);
        }
        if (isWall != walls.isWall(column, row - 1)) {
          addLine(borders, 0, 1, row + (isWall ? -radius : radius), radius);
        }
      }
    }
    double[] sorted = borders.stream().mapToDouble(Double::doubleValue).sorted().toArray();
    return joinFree(walls, sorted, radius);
  }

  /** Where the circle meets what is grown round an end of a run in a row. */
  private void addBorders(List<Double> borders, double column, double row, double radius) {
    addLine(borders, 1, 0, column - radius, radius);
    addLine(borders, 1, 0, column + radius, radius);
    addCircle(borders, column, row, radius);
    addCircle(borders, column, row + 1, radius);
  }

  /** Where nx X + ny Y = offset. */
  private void addLine(List<Double> borders, int nx, int ny, double offset, double radius) {
    double cos = (offset - nx * x - ny * y) / radius;
    if (Math.abs(cos) <= 1) {
      double middle = nx == 1 ? 0 : QUARTER;
      addAngle(borders, middle + Math.acos(cos));
      addAngle(borders, middle - Math.acos(cos));
    }
  }

  private void addCircle(List<Double> borders, double otherX, double otherY, double radius) {
    double distance = Math.hypot(otherX - x, otherY - y);
    if (distance > 0 && distance <= 2 * radius) {
      double middle = Math.atan2(otherY - y, otherX - x);
      double half = Math.acos(distance / (2 * radius));
      addAngle(borders, middle + half);
      addAngle(borders, middle - half);
    }
  }

  private void addAngle(List<Double> borders, double angle) {
    double fromBegin = fromBegin(angle);
    if (fromBegin > 0 && fromBegin < QUARTER) {
      borders.add(fromBegin);
    }
  }

  /** From {@code begin} to an angle, in [-pi, pi). */
  double fromBegin(double angle) {
    double turns = (angle - begin + Math.PI) / (2 * Math.PI);
    return (turns - Math.floor(turns)) * 2 * Math.PI - Math.PI;
  }

  /** Single points may be free too, where the disc just fits. */
  private double[] joinFree(WallRuns walls, double[] sorted, double radius) {
    double[] parts = new double[4 * sorted.length];
    int count = 0;
    for (int i = 0; i < sorted.length; i++) {
      double before = sorted[Math.max(0, i - 1)];
      if (isFree(walls, (before + sorted[i]) / 2, radius) && sorted[i] - before > 1e-12) {
        count = join(parts, count, before, sorted[i]);
      }
      if (isFree(walls, sorted[i], radius)) {
        count = join(parts, count, sorted[i], sorted[i]);
      }
    }
    return Arrays.copyOf(parts, count);
  }

  private static int join(double[] parts, int count, double from, double to) {
    if (count > 0 && from - parts[count - 1] < 1e-9) {
      parts[count - 1] = Math.max(to, parts[count - 1]);
      return count;
    }
    parts[count] = from;
    parts[count + 1] = to;
    return count + 2;
  }

  private boolean isFree(WallRuns walls, double fromBegin, double radius) {
    double angle = begin + fromBegin;
    return walls.isFree(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  }
}
