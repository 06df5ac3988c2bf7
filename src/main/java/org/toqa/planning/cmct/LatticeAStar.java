package org.toqa.planning.cmct;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.PriorityQueue;
import org.toqa.grid.Cell;
import org.toqa.planning.Heading;
import org.toqa.planning.cmct.LatticeResult.Effort;
import org.toqa.planning.cmct.LatticeResult.Found;
import org.toqa.planning.cmct.LatticeResult.NotFound;
import org.toqa.planning.cmct.LatticeResult.Reason;

/**
 * The shortest path over a lattice: A* (Hart, Nilsson and Raphael, 1968) as a textbook has it, with
 * an open list and a closed one, to compare {@link CmctWalk} with; the fleet plans by {@code
 * planning.JumpPointSearch}. The estimate is the shortest path on an empty lattice.
 */
public final class LatticeAStar {
  private final StepLattice lattice;
  private final Cell start;
  private final Cell goal;
  private final PriorityQueue<Open> open = new PriorityQueue<>();
  private final double[] lengths;
  private final byte[] headings;
  private final boolean[] closed;
  private long expanded;
  private int touched;

  /** A point on the open list; of equal sums the one nearer to the goal is first. */
  private record Open(double sum, double estimate, int point) implements Comparable<Open> {
    @Override
    public int compareTo(Open other) {
      int bySum = Double.compare(sum, other.sum);
      return bySum != 0 ? bySum : Double.compare(estimate, other.estimate);
    }
  }

  private LatticeAStar(StepLattice lattice, Cell start, Cell goal) {
    this.lattice = lattice;
    this.start = start;
    this.goal = goal;
    int size = lattice.width() * lattice.height();
    lengths = new double[size];
    Arrays.fill(lengths, Double.POSITIVE_INFINITY);
    headings = new byte[size];
    closed = new boolean[size];
  }

  /** Plans from one point of a lattice to another. */
  public static LatticeResult plan(StepLattice lattice, Cell start, Cell goal) {
    if (!lattice.isFree(start.column(), start.row())) {
      return new NotFound(Reason.START_BLOCKED, new Effort(0, 0));
    }
    if (!lattice.isFree(goal.column(), goal.row())) {
      return new NotFound(Reason.GOAL_BLOCKED, new Effort(0, 0));
    }
    return new LatticeAStar(lattice, start, goal).search();
  }

  private LatticeResult search() {
    push(index(start), 0, 0);
    while (!open.isEmpty()) {
      int point = open.remove().point();
      if (point == index(goal)) {
        return new Found(path(), new Effort(expanded, touched));
      }
      if (!closed[point]) {
        closed[point] = true;
        expand(point);
      }
    }
    return new NotFound(Reason.NO_PATH, new Effort(expanded, touched));
  }

  private void expand(int point) {
    expanded++;
    int column = point % lattice.width();
    int row = point / lattice.width();
    for (Heading heading : StepLattice.headings()) {
      if (lattice.allows(column, row, heading)) {
        int next = point + heading.dRow() * lattice.width() + heading.dColumn();
        push(next, lengths[point] + lattice.length(heading), heading.ordinal());
      }
    }
  }

  private void push(int point, double length, int heading) {
    if (!closed[point] && length < lengths[point]) {
      touched += lengths[point] == Double.POSITIVE_INFINITY ? 1 : 0;
      lengths[point] = length;
      headings[point] = (byte) heading;
      double estimate = estimate(point % lattice.width(), point / lattice.width());
      open.add(new Open(length + estimate, estimate, point));
    }
  }

  private double estimate(int column, int row) {
    int columns = Math.abs(goal.column() - column);
    int rows = Math.abs(goal.row() - row);
    int diagonals = Math.min(columns, rows);
    return diagonals * Math.hypot(lattice.stepX(), lattice.stepY())
        + (columns - diagonals) * lattice.stepX()
        + (rows - diagonals) * lattice.stepY();
  }

  private List<Cell> path() {
    List<Cell> points = new ArrayList<>(List.of(goal));
    Cell point = goal;
    while (!point.equals(start)) {
      Heading heading = StepLattice.headings()[headings[index(point)]];
      point = new Cell(point.column() - heading.dColumn(), point.row() - heading.dRow());
      points.add(point);
    }
    Collections.reverse(points);
    return points;
  }

  private int index(Cell point) {
    return point.row() * lattice.width() + point.column();
  }
}
