package org.toqa.planning.smooth;

import java.util.Arrays;

/**
 * Points in the plane by number, in a k-d tree (Bentley, "Multidimensional binary search trees used
 * for associative searching", 1975). Points come in a random order, so that it needs no balancing:
 * a search costs about the logarithm of their number.
 */
final class PointTree {
  private static final int NONE = -1;

  private double[] xs = new double[256];
  private double[] ys = new double[256];

  /** The subtree of points with a smaller coordinate, and after it the other one, by point. */
  private int[] below = new int[512];

  private int size;
  private int[] found = new int[64];
  private int foundCount;

  int size() {
    return size;
  }

  double x(int point) {
    return xs[point];
  }

  double y(int point) {
    return ys[point];
  }

  /** Adds a point; its number is how many there were before. */
  int add(double x, double y) {
    if (size == xs.length) {
      xs = Arrays.copyOf(xs, 2 * size);
      ys = Arrays.copyOf(ys, 2 * size);
      below = Arrays.copyOf(below, 4 * size);
    }
    int added = size++;
    xs[added] = x;
    ys[added] = y;
    below[2 * added] = NONE;
    below[2 * added + 1] = NONE;
    if (added > 0) {
      hang(added);
    }
    return added;
  }

  private void hang(int added) {
    int at = 0;
    boolean byX = true;
    while (true) {
      boolean isAfter = byX ? xs[added] >= xs[at] : ys[added] >= ys[at];
      int side = 2 * at + (isAfter ? 1 : 0);
      if (below[side] == NONE) {
        below[side] = added;
        return;
      }
      at = below[side];
      byX = !byX;
    }
  }

  /** The point nearest to a place; there must be one. */
  int nearest(double x, double y) {
    return nearest(0, true, x, y, 0);
  }

  private int nearest(int at, boolean byX, double x, double y, int best) {
    if (at == NONE) {
      return best;
    }
    int nearest = squared(at, x, y) < squared(best, x, y) ? at : best;
    double beyond = byX ? x - xs[at] : y - ys[at];
    int near = below[2 * at + (beyond >= 0 ? 1 : 0)];
    int far = below[2 * at + (beyond >= 0 ? 0 : 1)];
    nearest = nearest(near, !byX, x, y, nearest);
    return beyond * beyond < squared(nearest, x, y) ? nearest(far, !byX, x, y, nearest) : nearest;
  }

  /**
   * Finds the points within a distance of a place.
   *
   * @return how many; they are told by {@link #found}
   */
  int findWithin(double x, double y, double distance) {
    foundCount = 0;
    if (size > 0) {
      find(0, true, x, y, distance);
    }
    return foundCount;
  }

  /** One of the points that were found last. */
  int found(int index) {
    return found[index];
  }

  private void find(int at, boolean byX, double x, double y, double distance) {
    if (squared(at, x, y) <= distance * distance) {
      if (foundCount == found.length) {
        found = Arrays.copyOf(found, 2 * foundCount);
      }
      found[foundCount++] = at;
    }
    double beyond = byX ? x - xs[at] : y - ys[at];
    int smaller = below[2 * at];
    int larger = below[2 * at + 1];
    if (smaller != NONE && beyond <= distance) {
      find(smaller, !byX, x, y, distance);
    }
    if (larger != NONE && beyond >= -distance) {
      find(larger, !byX, x, y, distance);
    }
  }

  private double squared(int point, double x, double y) {
    double east = xs[point] - x;
    double north = ys[point] - y;
    return east * east + north * north;
  }
}
