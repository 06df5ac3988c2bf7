package org.toqa.planning.smooth;

import java.util.Arrays;

/**
 * Whether walls part two places for a disc; exact, without a search for a path.
 *
 * <p>What is blocked for the disc's centre is the union of occupied squares, each grown by the
 * radius. These are convex, so the union has the holes of the graph that links those that overlap
 * (the nerve theorem: Borsuk, 1948), which are two runs of squares less than the diameter apart. By
 * Alexander's duality start and goal are parted just if some closed walk in that graph crosses the
 * line from start to goal an odd number of times. Runs are therefore joined in sets that know by
 * which parity each is linked to the set's first one; a link that closes a walk of odd parity parts
 * the two. Cost: the runs times the rows within the diameter.
 */
final class Connectivity {
  /** Cells that the outside reaches beyond the grid. */
  private static final double OUTSIDE = 4;

  private final DiscSpace space;
  private final double diameter;
  private final WayPoints ends;

  // runs of occupied squares, by row from below: [left, right] x [row, row + 1]
  private int[] firstOfRow = new int[0];
  private double[] left = new double[64];
  private double[] right = new double[64];
  private double[] bottom = new double[64];
  private int count;

  private int[] setOf = new int[0];
  private boolean[] isOdd = new boolean[0];

  Connectivity(DiscSpace space, WayPoints ends) {
    this.space = space;
    this.ends = ends;
    this.diameter = 2 * space.radiusInCells();
  }

  /** Whether no path leads from start to goal; both must be free. */
  boolean isParted() {
    collectRuns();
    setOf = new int[count];
    isOdd = new boolean[count];
    Arrays.setAll(setOf, run -> run);
    for (int row = -1; row <= space.height(); row++) {
      for (int other = row; other <= Math.min(space.height(), row + diameter + 1); other++) {
        if (linkRows(row, other)) {
          return true;
        }
      }
    }
    return false;
  }

  private void collectRuns() {
    firstOfRow = new int[space.height() + 3];
    for (int row = -1; row <= space.height(); row++) {
      firstOfRow[row + 1] = count;
      if (row < 0 || row == space.height()) {
        addRun(-OUTSIDE, space.width() + OUTSIDE, row);
      } else {
        collectRuns(row);
      }
    }
    firstOfRow[space.height() + 2] = count;
  }

  private void collectRuns(int row) {
    double from = -OUTSIDE;
    boolean isInRun = true;
    for (int column = 0; column < space.width(); column++) {
      boolean isOccupied = space.isOccupied(column, row);
      if (isInRun && !isOccupied) {
        addRun(from, column, row);
      } else if (!isInRun && isOccupied) {
        from = column;
      }
      isInRun = isOccupied;
    }
    addRun(isInRun ? from : space.width(), space.width() + OUTSIDE, row);
  }

  private void addRun(double from, double to, double row) {
    if (count == left.length) {
      left = Arrays.copyOf(left, 2 * count);
      right = Arrays.copyOf(right, 2 * count);
      bottom = Arrays.copyOf(bottom, 2 * count);
    }
    left[count] = from;
    right[count] = to;
    bottom[count++] = row;
  }

  /** Links the runs of two rows that overlap when grown; true once a walk parts the two places. */
  private boolean linkRows(int row, int other) {
    double apart = Math.max(0, other - row - 1);
    if (apart >= diameter) {
      return false;
    }
    double reach = Math.sqrt(diameter * diameter - apart * apart);
    int begin = firstOfRow[other + 1];
    int end = firstOfRow[other + 2];
    for (int run = firstOfRow[row + 1]; run < firstOfRow[row + 2]; run++) {
      while (begin < end && right[begin] + reach <= left[run]) {
        begin++;
      }
      for (int near = begin; near < end && left[near] - reach < right[run]; near++) {
        if (near > run && link(run, near)) {
          return true;
        }
      }
    }
    return false;
  }

  /** True if this link closes a walk that crosses the line an odd number of times. */
  private boolean link(int run, int near) {
    boolean odd = crosses(run, near);
    int set = find(run);
    int other = find(near);
    boolean closing = odd ^ isOdd[run] ^ isOdd[near];
    if (set == other) {
      return closing;
    }
    setOf[other] = set;
    isOdd[other] = closing;
    return false;
  }

  /** The first of a run's set; afterwards the run's parity is that of its walk to it. */
  private int find(int run) {
    int root = run;
    boolean odd = false;
    while (setOf[root] != root) {
      odd ^= isOdd[root];
      root = setOf[root];
    }
    int at = run;
    while (setOf[at] != root && at != root) {
      int above = setOf[at];
      boolean rest = odd ^ isOdd[at];
      setOf[at] = root;
      isOdd[at] = odd;
      odd = rest;
      at = above;
    }
    return root;
  }

  /** Whether the walk from the middle of a run to that of another crosses the line oddly often. */
  private boolean crosses(int run, int near) {
    // through the nearest points of both: in between, the disc has no room either
    double fromX = Math.clamp((left[near] + right[near]) / 2, left[run], right[run]);
    double toX = Math.clamp(fromX, left[near], right[near]);
    double fromY = bottom[near] > bottom[run] ? bottom[run] + 1 : bottom[run] + 0.5;
    double toY = bottom[near] > bottom[run] ? bottom[near] : bottom[near] + 0.5;
    double nearX = Math.clamp(toX, left[run], right[run]);
    return crosses((left[run] + right[run]) / 2, bottom[run] + 0.5, nearX, fromY)
        ^ crosses(nearX, fromY, toX, toY)
        ^ crosses(toX, toY, (left[near] + right[near]) / 2, bottom[near] + 0.5);
  }

  /** Whether a piece of the walk crosses the line from start to goal. */
  private boolean crosses(double fromX, double fromY, double toX, double toY) {
    double from = side(fromX, fromY);
    double to = side(toX, toY);
    if (from >= 0 == to >= 0) {
      return false;
    }
    double share = from / (from - to);
    double alongX = ends.x(1) - ends.x(0);
    double alongY = ends.y(1) - ends.y(0);
    double along =
        (fromX + share * (toX - fromX) - ends.x(0)) * alongX
            + (fromY + share * (toY - fromY) - ends.y(0)) * alongY;
    return along > 0 && along < alongX * alongX + alongY * alongY;
  }

  private double side(double x, double y) {
    return (ends.x(1) - ends.x(0)) * (y - ends.y(0)) - (ends.y(1) - ends.y(0)) * (x - ends.x(0));
  }
}
