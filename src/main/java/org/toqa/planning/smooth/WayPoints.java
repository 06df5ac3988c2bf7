package org.toqa.planning.smooth;

import java.util.Arrays;

/** A line through points, cells, which can grow; the first is the start, the last the goal. */
final class WayPoints {
  private double[] xs;
  private double[] ys;
  private int size;

  WayPoints() {
    xs = new double[16];
    ys = new double[16];
  }

  private WayPoints(WayPoints other) {
    xs = other.xs.clone();
    ys = other.ys.clone();
    size = other.size;
  }

  WayPoints copy() {
    return new WayPoints(this);
  }

  int size() {
    return size;
  }

  double x(int index) {
    return xs[index];
  }

  double y(int index) {
    return ys[index];
  }

  void clear() {
    size = 0;
  }

  WayPoints add(double x, double y) {
    insert(size, x, y);
    return this;
  }

  void insert(int index, double x, double y) {
    if (size == xs.length) {
      xs = Arrays.copyOf(xs, 2 * size);
      ys = Arrays.copyOf(ys, 2 * size);
    }
    System.arraycopy(xs, index, xs, index + 1, size - index);
    System.arraycopy(ys, index, ys, index + 1, size - index);
    xs[index] = x;
    ys[index] = y;
    size++;
  }

  /** Takes the points from an index up to, but without, another one out. */
  void remove(int from, int to) {
    System.arraycopy(xs, to, xs, from, size - to);
    System.arraycopy(ys, to, ys, from, size - to);
    size -= to - from;
  }

  void set(int index, double x, double y) {
    xs[index] = x;
    ys[index] = y;
  }

  void reverse() {
    for (int i = 0, j = size - 1; i < j; i++, j--) {
      double x = xs[i];
      double y = ys[i];
      set(i, xs[j], ys[j]);
      set(j, x, y);
    }
  }

  /** Cells along the line. */
  double length() {
    double length = 0;
    for (int i = 1; i < size; i++) {
      length += leg(i);
    }
    return length;
  }

  /** Cells from the point before this one to this one. */
  double leg(int index) {
    return distance(xs[index - 1], ys[index - 1], xs[index], ys[index]);
  }

  /** Whether a disc may go along all of it. */
  boolean isFreeIn(DiscSpace space) {
    for (int i = 1; i < size; i++) {
      if (!space.isFree(xs[i - 1], ys[i - 1], xs[i], ys[i])) {
        return false;
      }
    }
    return true;
  }

  static double distance(double fromX, double fromY, double toX, double toY) {
    double x = toX - fromX;
    double y = toY - fromY;
    return Math.sqrt(x * x + y * y);
  }
}
