package org.toqa.planning;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * A path on the grid.
 *
 * @param steps the states in order, at least one; two neighbours differ by a move of one cell along
 *     the first one's heading, or by a turn on the spot (same cell, other heading)
 * @param cost in cells: 1 or sqrt 2 for a move, 1/2 for each 45 degrees turned on the spot
 * @param turnsOnSpot how often the robot turns on the spot between start and goal; 0 where the
 *     three-move rule sufficed
 */
public record Path(List<Step> steps, double cost, int turnsOnSpot) {
  private static final double SQRT_2 = Math.sqrt(2);

  /** A cell, and the heading in which it is left (for the last one: was entered). */
  public record Step(Cell cell, Heading heading) {}

  public Path {
    steps = List.copyOf(steps);
    if (steps.isEmpty()) {
      throw new IllegalArgumentException("A path has at least the cell in which it starts.");
    }
  }

  /**
   * The path that these moves make.
   *
   * @param turnsOnSpot whether a change of heading by more than 45 degrees is a turn on the spot,
   *     with its step and its cost; otherwise it is a corner like any other
   */
  static Path of(Cell start, MoveSequence moves, boolean turnsOnSpot) {
    List<Step> steps = new ArrayList<>(moves.size() + 1);
    double cost = 0;
    int turns = 0;
    Cell cell = start;
    Heading heading = moves.size() == 0 ? Heading.EAST : moves.get(0);
    for (int i = 0; i < moves.size(); i++) {
      Heading move = moves.get(i);
      int eighths = turnsOnSpot ? Math.abs(heading.eighthsTo(move)) : 0;
      if (eighths > 1) {
        steps.add(new Step(cell, heading));
        cost += eighths / 2.0;
        turns++;
      }
      steps.add(new Step(cell, move));
      cost += move.isDiagonal() ? SQRT_2 : 1;
      cell = new Cell(cell.column() + move.dColumn(), cell.row() + move.dRow());
      heading = move;
    }
    steps.add(new Step(cell, heading));
    return new Path(steps, cost, turns);
  }

  /** The cells in the order in which they are entered; one may come again. */
  public List<Cell> cells() {
    List<Cell> cells = new ArrayList<>();
    for (Step step : steps) {
      if (cells.isEmpty() || !cells.getLast().equals(step.cell())) {
        cells.add(step.cell());
      }
    }
    return cells;
  }

  /**
   * The points where the path bends or the robot turns, and the goal; not the start. Empty for a
   * path that stays in its cell. Metres, map frame.
   */
  public List<Waypoint> waypoints(OccupancyGrid grid) {
    List<Waypoint> waypoints = new ArrayList<>();
    for (int i = 1; i < steps.size(); i++) {
      Step before = steps.get(i - 1);
      Step here = steps.get(i);
      boolean turned = before.cell().equals(here.cell());
      boolean turnsNext = i + 1 < steps.size() && steps.get(i + 1).cell().equals(here.cell());
      boolean bends = before.heading() != here.heading();
      boolean ends = i == steps.size() - 1;
      if (!turned && (bends || turnsNext || ends)) {
        waypoints.add(new Waypoint(grid.centre(here.cell()), turnsNext));
      }
    }
    return waypoints;
  }
}
