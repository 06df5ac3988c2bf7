package org.toqa.planning;

import java.util.List;
import java.util.Optional;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Path.Step;

/** Judges a path by the rules alone, apart from every planner. */
public final class PlanChecker {
  private static final double ROUNDING = 1e-6;

  /** What a path may do at a corner. */
  public enum Rule {
    /** Any change of heading. */
    OCTILE,
    /** Changes by 45 degrees while moving; larger ones by a turn on the spot. */
    HEADING
  }

  private PlanChecker() {}

  /** The first rule that the path breaks, in a sentence; empty if it keeps them all. */
  public static Optional<String> violation(
      OccupancyGrid grid, Cell start, Cell goal, Path path, Rule rule) {
    List<Step> steps = path.steps();
    if (!steps.getFirst().cell().equals(start) || !steps.getLast().cell().equals(goal)) {
      return Optional.of("The path does not lead from " + start + " to " + goal + ".");
    }
    if (!grid.isFree(start)) {
      return Optional.of("The start " + start + " is blocked.");
    }
    double cost = 0;
    int turns = 0;
    for (int i = 1; i < steps.size(); i++) {
      Step from = steps.get(i - 1);
      Step to = steps.get(i);
      int eighths = eighths(from.heading(), to.heading());
      if (from.cell().equals(to.cell())) {
        boolean alone = i == 1 || steps.get(i - 2).heading() == from.heading();
        if (rule == Rule.OCTILE || eighths < 2 || !alone) {
          return Optional.of(
              "At " + from.cell() + " the path turns on the spot where the rule forbids it.");
        }
        turns++;
        cost += eighths / 2.0;
      } else {
        if (!isMove(grid, from, to.cell())) {
          return Optional.of("There is no move from " + from + " to " + to.cell() + ".");
        }
        if (i == steps.size() - 1 && eighths != 0) {
          return Optional.of("The last heading is not the one in which the goal is entered.");
        }
        if (rule == Rule.HEADING && eighths > 1) {
          return Optional.of(
              "At " + to.cell() + " the path bends by " + 45 * eighths + " degrees.");
        }
        cost += Math.hypot(from.heading().dColumn(), from.heading().dRow());
      }
    }
    if (turns != path.turnsOnSpot()) {
      return Optional.of("The path turns " + turns + " times, not " + path.turnsOnSpot() + ".");
    }
    if (!(Math.abs(cost - path.cost()) <= ROUNDING * Math.max(1, cost))) {
      return Optional.of("The path costs " + cost + " cells, not " + path.cost() + ".");
    }
    return Optional.empty();
  }

  private static int eighths(Heading a, Heading b) {
    int apart = Math.floorMod(b.ordinal() - a.ordinal(), 8);
    return Math.min(apart, 8 - apart);
  }

  private static boolean isMove(OccupancyGrid grid, Step from, Cell to) {
    int column = from.cell().column();
    int row = from.cell().row();
    Heading heading = from.heading();
    return to.column() == column + heading.dColumn()
        && to.row() == row + heading.dRow()
        && grid.isFree(to)
        && grid.isFree(column + heading.dColumn(), row)
        && grid.isFree(column, row + heading.dRow());
  }
}
