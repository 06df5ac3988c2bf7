package org.toqa.planning;

import java.util.List;
import org.toqa.grid.Cell;

/**
 * A way on the grid.
 *
 * @param steps the states in order; two neighbours differ by a move of one cell, or by a turn on
 *     the spot (same cell, other heading)
 * @param cost in cells: 1 or sqrt 2 for a move, 1/2 for each 45 degrees turned on the spot
 * @param turnsOnSpot how often the robot turns on the spot between start and goal; 0 where the
 *     three-move rule sufficed
 */
public record Path(List<Step> steps, double cost, int turnsOnSpot) {

  /** A cell, and the heading in which it is left (for the last one: was entered). */
  public record Step(Cell cell, Heading heading) {}

  public Path {
    steps = List.copyOf(steps);
  }

  public List<Cell> cells() {
    return steps.stream().map(Step::cell).distinct().toList();
  }
}
