package org.toqa.planning.smooth;

import java.util.ArrayList;
import java.util.List;

/**
 * The passages of a grid that are hardly wider than the disc: chance does not meet those that just
 * fit. Each is a free straight line through the middle of a gap, as far to both sides as is free.
 *
 * <p>Two squares are nearest to each other at two corners, or along two sides that face each other.
 * So a passage leads at a right angle through the middle between two corners of walls, or along the
 * middle between two sides. Cost: the cells, and for each corner the points of a thin ring.
 */
final class Passages {
  /** By how much a passage may be wider than the disc: a share of its radius, and cells. */
  private static final double WIDER_BY_RADIUS = 0.06;

  private static final double WIDER_BY_CELLS = 0.5;

  /** Passages are lines this many radii long to each side, where that is free. */
  private static final double LONGEST = 2;

  private static final int HALVINGS = 16;

  private final DiscSpace space;
  private final double least;
  private final double most;
  private final List<Passage> found = new ArrayList<>();

  /** A free line, cells. */
  record Passage(double fromX, double fromY, double toX, double toY) {}

  private Passages(DiscSpace space) {
    this.space = space;
    this.least = 2 * space.radiusInCells();
    this.most = least + Math.max(WIDER_BY_CELLS, WIDER_BY_RADIUS * space.radiusInCells());
  }

  /** All of a space. */
  static List<Passage> of(DiscSpace space) {
    Passages passages = new Passages(space);
    passages.findBetweenCorners();
    passages.findBetweenLevelCorners();
    passages.findBetweenSides(false);
    passages.findBetweenSides(true);
    return List.copyOf(passages.found);
  }

  private void findBetweenCorners() {
    List<int[]> ring = ring();
    for (int y = 0; y <= space.height(); y++) {
      for (int x = 0; x <= space.width(); x++) {
        // upward ones only: each pair once
        boolean opensToNorthEast = isCorner(x, y, 1, 1);
        boolean opensToNorthWest = isCorner(x, y, -1, 1);
        for (int[] step : opensToNorthEast || opensToNorthWest ? ring : List.<int[]>of()) {
          if (opensToNorthEast && isCorner(x + step[0], y + step[1], -1, -1)) {
            add(x, y, step[0], step[1]);
          }
          if (opensToNorthWest && isCorner(x - step[0], y + step[1], 1, -1)) {
            add(x, y, -step[0], step[1]);
          }
        }
      }
    }
  }

  /** Between corners in one line of the grid, of squares that are on different sides of it. */
  private void findBetweenLevelCorners() {
    for (int gap = (int) Math.ceil(least); gap <= most; gap++) {
      for (int y = 0; y <= space.height(); y++) {
        for (int x = 0; x <= space.width(); x++) {
          if (areOffset(x - 1, y, x + gap, y, 0, -1) && isClear(x, y, gap, 1, 0)) {
            add(x, y, gap, 0);
          }
          if (areOffset(x, y - 1, x, y + gap, -1, 0) && isClear(x, y, gap, 0, 1)) {
            add(x, y, 0, gap);
          }
        }
      }
    }
  }

  /**
   * Whether of two squares, and those beside each across the line, just an opposite pair is wall.
   */
  private boolean areOffset(int x, int y, int otherX, int otherY, int besideX, int besideY) {
    boolean first = space.isOccupied(x, y);
    boolean second = space.isOccupied(x + besideX, y + besideY);
    return first != second
        && space.isOccupied(otherX, otherY) == second
        && space.isOccupied(otherX + besideX, otherY + besideY) == first;
  }

  /** Whether the squares on both sides of a line are free. */
  private boolean isClear(int x, int y, int length, int east, int north) {
    for (int i = 0; i < length; i++) {
      int column = x + i * east;
      int row = y + i * north;
      if (space.isOccupied(column, row) || space.isOccupied(column - north, row - east)) {
        return false;
      }
    }
    return true;
  }

  /** Steps to the north-east that are as long as a passage may be wide. */
  private List<int[]> ring() {
    List<int[]> ring = new ArrayList<>();
    for (int up = 1; up <= most; up++) {
      for (int along = 1; along <= most; along++) {
        double length = Math.sqrt((double) up * up + (double) along * along);
        if (length >= least && length <= most) {
          ring.add(new int[] {along, up});
        }
      }
    }
    return ring;
  }

  /** Whether only the square opposite to a direction is wall, of those two beside it and that. */
  private boolean isCorner(int x, int y, int east, int north) {
    int ahead = east > 0 ? x : x - 1;
    int behind = east > 0 ? x - 1 : x;
    int above = north > 0 ? y : y - 1;
    int below = north > 0 ? y - 1 : y;
    return space.isOccupied(behind, below)
        && !space.isOccupied(ahead, below)
        && !space.isOccupied(behind, above);
  }

  /** Between the corners at a point and a step from it. */
  private void add(double x, double y, double alongX, double alongY) {
    double middleX = x + alongX / 2;
    double middleY = y + alongY / 2;
    addThrough(middleX, middleY, middleX, middleY, -alongY, alongX);
  }

  /** Lengthens a line in its direction to both sides, as far as is free. */
  private void addThrough(
      double fromX, double fromY, double toX, double toY, double alongX, double alongY) {
    if (!space.isFree(fromX, fromY, toX, toY)) {
      return;
    }
    double scale = LONGEST * space.radiusInCells() / Math.sqrt(alongX * alongX + alongY * alongY);
    double forward = freeShare(toX, toY, scale * alongX, scale * alongY) * scale;
    double back = freeShare(fromX, fromY, -scale * alongX, -scale * alongY) * scale;
    found.add(
        new Passage(
            fromX - back * alongX,
            fromY - back * alongY,
            toX + forward * alongX,
            toY + forward * alongY));
  }

  private double freeShare(double x, double y, double alongX, double alongY) {
    if (space.isFree(x, y, x + alongX, y + alongY)) {
      return 1;
    }
    double free = 0;
    double blocked = 1;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (free + blocked) / 2;
      if (space.isFree(x, y, x + middle * alongX, y + middle * alongY)) {
        free = middle;
      } else {
        blocked = middle;
      }
    }
    return free;
  }

  /**
   * Between sides that face each other across free cells of a row or column; neighbouring rows with
   * the same gap are one passage.
   *
   * @param upright whether the gaps are in columns, and the passages lead from west to east
   */
  private void findBetweenSides(boolean upright) {
    int lines = upright ? space.width() : space.height();
    int length = upright ? space.height() : space.width();
    int widest = (int) Math.floor(most);
    for (int line = 0; line < lines; line++) {
      int begin = 0;
      for (int at = 0; at <= length; at++) {
        if (isOccupied(upright, line, at)) {
          int gap = at - begin;
          if (gap >= least && gap <= widest && !isGap(upright, line - 1, begin, at)) {
            addBetweenSides(upright, line, begin, at);
          }
          begin = at + 1;
        }
      }
    }
  }

  private void addBetweenSides(boolean upright, int line, int begin, int end) {
    int last = line;
    while (isGap(upright, last + 1, begin, end)) {
      last++;
    }
    double middle = (begin + end) / 2.0;
    if (upright) {
      addThrough(line, middle, last + 1.0, middle, 1, 0);
    } else {
      addThrough(middle, line, middle, last + 1.0, 0, 1);
    }
  }

  private boolean isGap(boolean upright, int line, int begin, int end) {
    if (!isOccupied(upright, line, begin - 1) || !isOccupied(upright, line, end)) {
      return false;
    }
    for (int at = begin; at < end; at++) {
      if (isOccupied(upright, line, at)) {
        return false;
      }
    }
    return true;
  }

  private boolean isOccupied(boolean upright, int line, int at) {
    return upright ? space.isOccupied(line, at) : space.isOccupied(at, line);
  }
}
