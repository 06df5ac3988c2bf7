package org.toqa.traffic.floor;

import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;

/**
 * The points between which the leader of a formation drives, in rows and columns over a floor, and
 * eight headings at each. A state is {@code 8 (row columns + column) + heading}.
 *
 * @param step metres between neighbours of a row or a column
 * @param firstPoint the one in the south-west, metres, map frame
 */
record FormationLattice(double step, Vec2 firstPoint, int columns, int rows) {
  /** Between neighbouring headings, radians. */
  static final double EIGHTH = Math.PI / 4;

  static final double ROUNDING = 1e-6;

  /** Points are at most so far apart, metres. */
  private static final double WIDEST_STEP = 0.15;

  private static final Heading[] HEADINGS = Heading.values();

  /** Its first point is the middle of the grid's cell in the south-west. */
  static FormationLattice of(OccupancyGrid grid) {
    double cell = grid.resolution();
    double step =
        cell > WIDEST_STEP
            ? cell / Math.ceil(cell / WIDEST_STEP)
            : cell * Math.floor(WIDEST_STEP / cell);
    return new FormationLattice(
        step,
        grid.origin().plus(new Vec2(cell / 2, cell / 2)),
        (int) ((grid.width() - 1) * cell / step + ROUNDING) + 1,
        (int) ((grid.height() - 1) * cell / step + ROUNDING) + 1);
  }

  /** Metres that the load may stand beside its goal. */
  static double goalTolerance(OccupancyGrid grid) {
    return Math.min(WIDEST_STEP, Math.max(grid.resolution(), WIDEST_STEP / 2)) * 0.8;
  }

  /** The pose on the lattice that is nearest, map frame. */
  Pose nearest(Pose pose) {
    return new Pose(
        firstPoint.x() + Math.rint((pose.x() - firstPoint.x()) / step) * step,
        firstPoint.y() + Math.rint((pose.y() - firstPoint.y()) / step) * step,
        Heading.nearest(pose.theta()).ordinal() * EIGHTH);
  }

  int stateCount() {
    return HEADINGS.length * columns * rows;
  }

  /**
   * @param heading as in {@link Heading#ordinal}
   */
  int state(int column, int row, int heading) {
    return 8 * (row * columns + column) + heading;
  }

  /** The state of a leader that stands at a pose exactly, map frame; -1: none. */
  int stateAt(Pose pose) {
    int column = (int) Math.rint((pose.x() - firstPoint.x()) / step);
    int row = (int) Math.rint((pose.y() - firstPoint.y()) / step);
    if (column < 0 || row < 0 || column >= columns || row >= rows) {
      return -1;
    }
    int state = state(column, row, Heading.nearest(pose.theta()).ordinal());
    Pose there = pose(state);
    boolean isThere =
        there.distanceTo(pose) < ROUNDING
            && Math.abs(Angles.difference(there.theta(), pose.theta())) < ROUNDING;
    return isThere ? state : -1;
  }

  /** Where the leader stands in a state, map frame. */
  Pose pose(int state) {
    int point = state >> 3;
    int column = point % columns;
    int row = point / columns;
    return new Pose(
        firstPoint.x() + column * step, firstPoint.y() + row * step, (state & 7) * EIGHTH);
  }

  /** The state one step on, in the heading of that step; -1: outside. */
  int neighbour(int state, int heading) {
    int point = state >> 3;
    int column = point % columns + HEADINGS[heading].dColumn();
    int row = point / columns - HEADINGS[heading].dRow();
    return column < 0 || row < 0 || column >= columns || row >= rows
        ? -1
        : state(column, row, heading);
  }

  /** Metres of one step in a heading. */
  double length(int heading) {
    return (heading & 1) == 0 ? step : step * Math.sqrt(2);
  }

  /** Is given points, as columns and rows. */
  interface PointVisitor {
    void visit(int column, int row);
  }

  /**
   * Visits the points of a square, row by row.
   *
   * @param middle metres, map frame
   * @param reach from the middle to a side, metres
   */
  void forEachPointAround(Vec2 middle, double reach, PointVisitor visitor) {
    int steps = (int) Math.ceil(reach / step);
    int column = (int) Math.round((middle.x() - firstPoint.x()) / step);
    int row = (int) Math.round((middle.y() - firstPoint.y()) / step);
    for (int r = Math.max(0, row - steps); r <= Math.min(rows - 1, row + steps); r++) {
      for (int c = Math.max(0, column - steps); c <= Math.min(columns - 1, column + steps); c++) {
        visitor.visit(c, r);
      }
    }
  }
}
