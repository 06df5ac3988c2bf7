package org.toqa.fleet.floor;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.DistanceField;

/**
 * The path down a field of distances: from each cell to one beside it that is nearer by as much as
 * the step is long.
 */
final class FieldPath {
  /** Cells; sums of lengths are not exact. */
  private static final double ROUNDING = 0.02;

  private final OccupancyGrid grid;
  private final DistanceField field;

  /** To a cell beside it. */
  private record Step(int dColumn, int dRow) {
    double length() {
      return Math.hypot(dColumn, dRow);
    }

    Cell from(Cell cell) {
      return new Cell(cell.column() + dColumn, cell.row() + dRow);
    }
  }

  private static final List<Step> STEPS =
      List.of(
          new Step(1, 0),
          new Step(0, 1),
          new Step(-1, 0),
          new Step(0, -1),
          new Step(1, 1),
          new Step(-1, 1),
          new Step(-1, -1),
          new Step(1, -1));

  FieldPath(OccupancyGrid grid, DistanceField field) {
    this.grid = grid;
    this.field = field;
  }

  /**
   * The corners, both ends included, metres, map frame; empty where there is no path.
   *
   * @param to where the field leads
   */
  List<Vec2> from(Vec2 from, Vec2 to) {
    Cell cell = nearest(grid.cellAt(from));
    if (Double.isInfinite(field.from(cell))) {
      return List.of();
    }
    List<Vec2> corners = new ArrayList<>(List.of(from));
    Step before = null;
    for (Step step = next(cell, null); step != null; step = next(cell, before)) {
      if (before != null && !step.equals(before)) {
        corners.add(grid.centre(cell));
      }
      cell = step.from(cell);
      before = step;
    }
    corners.add(to);
    return List.copyOf(corners);
  }

  /** A robot may be stopped a little nearer to a wall than it would drive. */
  private Cell nearest(Cell cell) {
    if (Double.isFinite(field.from(cell))) {
      return cell;
    }
    Cell best = cell;
    for (Step step : STEPS) {
      Cell beside = step.from(cell);
      if (field.from(beside) < field.from(best)) {
        best = beside;
      }
    }
    return best;
  }

  /** Null: it is there. */
  private @Nullable Step next(Cell cell, @Nullable Step before) {
    double here = field.from(cell);
    if (here == 0) {
      return null;
    }
    if (before != null && isDown(cell, before, here)) {
      return before;
    }
    return STEPS.stream().filter(step -> isDown(cell, step, here)).findFirst().orElse(null);
  }

  private boolean isDown(Cell cell, Step step, double here) {
    return Math.abs(field.from(step.from(cell)) + step.length() - here) < ROUNDING;
  }
}
