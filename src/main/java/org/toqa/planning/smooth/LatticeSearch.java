package org.toqa.planning.smooth;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;

/**
 * A first path where neither {@link Lattice} nor chance finds one, as between turned walls that
 * just let the disc through: A* (Hart, Nilsson and Raphael, 1968) over the points of a lattice,
 * with lines to the eight around. It is no shortest path; the tree and the swarm shorten it.
 *
 * <p>Passages between squares of a grid are narrowest where both coordinates are multiples of half
 * a cell, so a lattice of half cells goes through what a disc fits through exactly; where the disc
 * is no wider than a cell, the middles of the cells are enough.
 */
final class LatticeSearch {
  private static final int PAGE_BITS = 6;
  private static final int PAGE = 1 << PAGE_BITS;

  /** A lattice with more points on a side is not searched. */
  private static final int LONGEST_SIDE = 1 << 15;

  /** So many times the distance to the goal: the search is shorter and its path hardly longer. */
  private static final double WEIGHT = 1.1;

  /** How many lattice points around start and goal are tried, on each side. */
  private static final int AROUND = 3;

  /** How many points are expanded between two looks at the clock. */
  private static final int BETWEEN_LOOKS = 64;

  private static final int[] COLUMNS = {1, 1, 0, -1, -1, -1, 0, 1};
  private static final int[] ROWS = {0, 1, 1, 1, 0, -1, -1, -1};
  private static final byte FROM_START = 8;

  private final DiscSpace space;
  private final double spacing;
  private final boolean fitsInCell;
  private final double offset;
  private final int columns;
  private final int rows;
  private final int pagesAcross;
  private final float[][] costs;
  private final byte[][] directions;
  private final BooleanSupplier isOver;
  private final WayPoints ends;
  private boolean wasStopped;

  // a heap of points by cost and distance to the goal
  private float[] keys = new float[1024];
  private int[] heap = new int[1024];
  private int heapSize;

  /**
   * @param spacing cells between neighbouring points: 1/2 times a power of two. One point is in the
   *     grid's lower left corner; but where the disc fits into a cell and the spacing is 1, the
   *     points are the middles of the cells
   * @param isOver whether to stop
   */
  LatticeSearch(DiscSpace space, WayPoints ends, double spacing, BooleanSupplier isOver) {
    this.space = space;
    this.ends = ends;
    this.spacing = spacing;
    this.fitsInCell = spacing == 1 && space.radiusInCells() <= 0.5;
    this.offset = fitsInCell ? 0.5 : 0;
    this.isOver = isOver;
    this.columns = (int) Math.floor(space.width() / spacing - offset) + 1;
    this.rows = (int) Math.floor(space.height() / spacing - offset) + 1;
    this.pagesAcross = (columns >> PAGE_BITS) + 1;
    int pages = isTooLarge() ? 0 : pagesAcross * ((rows >> PAGE_BITS) + 1);
    this.costs = new float[pages][];
    this.directions = new byte[pages][];
  }

  /**
   * The spacing at which to begin: half the disc's radius where that is many cells, the middles of
   * the cells where the disc is no wider than one.
   */
  static double firstSpacing(DiscSpace space) {
    if (space.radiusInCells() <= 0.5) {
      return 1;
    }
    double spacing = 0.5;
    while (4 * spacing <= space.radiusInCells()) {
      spacing *= 2;
    }
    return spacing;
  }

  /** Whether there are more points than are searched. */
  boolean isTooLarge() {
    return columns > LONGEST_SIDE || rows > LONGEST_SIDE;
  }

  /** Whether the search ended because it was told to. */
  boolean wasStopped() {
    return wasStopped;
  }

  /** A free path from start to goal; null where the lattice has none, or time is over. */
  @Nullable WayPoints search() {
    if (isTooLarge()) {
      return null;
    }
    pushAroundStart();
    int untilLook = BETWEEN_LOOKS;
    while (heapSize > 0) {
      if (--untilLook == 0) {
        untilLook = BETWEEN_LOOKS;
        if (isOver.getAsBoolean()) {
          wasStopped = true;
          return null;
        }
      }
      float key = keys[0];
      int point = pop();
      float cost = costOf(point);
      if (key > cost + (float) heuristic(point) * 1.000001f) {
        continue; // it was reached by a shorter path since
      }
      if (isBeside(point, 1) && space.isFree(x(point), y(point), ends.x(1), ends.y(1))) {
        return pathTo(point);
      }
      expand(point, cost);
    }
    return null;
  }

  private void pushAroundStart() {
    int column = (int) Math.round(ends.x(0) / spacing - offset);
    int row = (int) Math.round(ends.y(0) / spacing - offset);
    for (int j = row - AROUND; j <= row + AROUND; j++) {
      for (int i = column - AROUND; i <= column + AROUND; i++) {
        if (i >= 0 && j >= 0 && i < columns && j < rows) {
          int point = j * columns + i;
          if (space.isFree(ends.x(0), ends.y(0), x(point), y(point))) {
            double cost = WayPoints.distance(ends.x(0), ends.y(0), x(point), y(point));
            reach(point, (float) cost, FROM_START);
          }
        }
      }
    }
  }

  private boolean isBeside(int point, int end) {
    double reach = (AROUND + 0.5) * spacing;
    return Math.abs(x(point) - ends.x(end)) <= reach && Math.abs(y(point) - ends.y(end)) <= reach;
  }

  private void expand(int point, float cost) {
    int column = point % columns;
    int row = point / columns;
    for (byte direction = 0; direction < 8; direction++) {
      int i = column + COLUMNS[direction];
      int j = row + ROWS[direction];
      if (i < 0 || j < 0 || i >= columns || j >= rows) {
        continue;
      }
      int other = j * columns + i;
      float through = cost + (float) (spacing * ((direction & 1) == 0 ? 1 : Math.sqrt(2)));
      if (through < costOf(other) && isFree(column, row, i, j)) {
        reach(other, through, direction);
      }
    }
  }

  private boolean isFree(int column, int row, int toColumn, int toRow) {
    if (fitsInCell) {
      return !space.isOccupied(toColumn, toRow)
          && !space.isOccupied(toColumn, row)
          && !space.isOccupied(column, toRow);
    }
    return space.isFree(column * spacing, row * spacing, toColumn * spacing, toRow * spacing);
  }

  private WayPoints pathTo(int last) {
    WayPoints path = new WayPoints().add(ends.x(1), ends.y(1));
    int point = last;
    byte direction = directionOf(point);
    path.add(x(point), y(point));
    while (direction != FROM_START) {
      point -= ROWS[direction] * columns + COLUMNS[direction];
      direction = directionOf(point);
      path.add(x(point), y(point));
    }
    path.add(ends.x(0), ends.y(0));
    path.reverse();
    return path;
  }

  private double x(int point) {
    return (point % columns + offset) * spacing;
  }

  private double y(int point) {
    int row = point / columns;
    return (row + offset) * spacing;
  }

  private double heuristic(int point) {
    return WEIGHT * WayPoints.distance(x(point), y(point), ends.x(1), ends.y(1));
  }

  private int page(int point) {
    return ((point / columns) >> PAGE_BITS) * pagesAcross + (point % columns >> PAGE_BITS);
  }

  private int inPage(int point) {
    return (((point / columns) & (PAGE - 1)) << PAGE_BITS) + ((point % columns) & (PAGE - 1));
  }

  private float costOf(int point) {
    float[] page = costs[page(point)];
    return page == null ? Float.POSITIVE_INFINITY : page[inPage(point)];
  }

  private byte directionOf(int point) {
    return directions[page(point)][inPage(point)];
  }

  private void reach(int point, float cost, byte direction) {
    int page = page(point);
    if (costs[page] == null) {
      costs[page] = new float[PAGE * PAGE];
      Arrays.fill(costs[page], Float.POSITIVE_INFINITY);
      directions[page] = new byte[PAGE * PAGE];
    }
    costs[page][inPage(point)] = cost;
    directions[page][inPage(point)] = direction;
    push(point, cost + (float) heuristic(point));
  }

  private void push(int point, float key) {
    if (heapSize == heap.length) {
      heap = Arrays.copyOf(heap, 2 * heapSize);
      keys = Arrays.copyOf(keys, 2 * heapSize);
    }
    int at = heapSize++;
    while (at > 0 && keys[(at - 1) / 2] > key) {
      heap[at] = heap[(at - 1) / 2];
      keys[at] = keys[(at - 1) / 2];
      at = (at - 1) / 2;
    }
    heap[at] = point;
    keys[at] = key;
  }

  private int pop() {
    int first = heap[0];
    int last = heap[--heapSize];
    float key = keys[heapSize];
    int at = 0;
    while (2 * at + 1 < heapSize) {
      int child = 2 * at + 1;
      if (child + 1 < heapSize && keys[child + 1] < keys[child]) {
        child++;
      }
      if (keys[child] >= key) {
        break;
      }
      heap[at] = heap[child];
      keys[at] = keys[child];
      at = child;
    }
    heap[at] = last;
    keys[at] = key;
    return first;
  }
}
