package org.toqa.planning;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.OneWay;
import org.toqa.planning.Path.Step;

/** Judges a path by the rules alone, apart from every planner. */
public final class PlanChecker {
  private static final double ROUNDING = 1e-6;

  /** A move is looked at in so many pieces to see which areas it leads through. */
  private static final int PIECES = 64;

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
        && grid.isFree(column, row + heading.dRow())
        && isInDirection(grid, from.cell(), to);
  }

  /** Whether a straight between the middles of two cells keeps the directions of the areas. */
  static boolean isInDirection(OccupancyGrid grid, Cell from, Cell to) {
    int columns = to.column() - from.column();
    int north = from.row() - to.row();
    for (OneWay one : grid.rules().oneWay()) {
      Vec2 direction = one.direction().vector();
      if (columns * direction.x() + north * direction.y() < 0
          && points(grid, from, to).anyMatch(point -> isIn(one.area(), point))) {
        return false;
      }
    }
    for (OneWay one : grid.rules().approaches()) {
      Vec2 direction = one.direction().vector();
      boolean isStraight = columns == direction.x() && north == direction.y();
      if (!isStraight
          && !isIn(one.area(), grid.centre(from))
          && points(grid, from, to).anyMatch(point -> isIn(one.area(), point))) {
        return false;
      }
    }
    return true;
  }

  private static Stream<Vec2> points(OccupancyGrid grid, Cell from, Cell to) {
    Vec2 start = grid.centre(from);
    Vec2 way = grid.centre(to).minus(start);
    return IntStream.rangeClosed(0, PIECES)
        .mapToObj(i -> start.plus(way.times((double) i / PIECES)));
  }

  private static boolean isIn(Area area, Vec2 point) {
    double east = point.x() - area.low().x();
    double north = point.y() - area.low().y();
    return east > ROUNDING
        && east < area.width() - ROUNDING
        && north > ROUNDING
        && north < area.height() - ROUNDING;
  }
}
