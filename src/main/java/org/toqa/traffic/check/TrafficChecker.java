package org.toqa.traffic.check;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.OneWay;
import org.toqa.planning.Heading;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;

/**
 * Judges what robots did, by the rules alone: it knows no planner and uses nothing that one uses.
 *
 * <p>The rules: robots are on free cells; a step is one the model allows; no two are on one cell;
 * no two change places; no step leads against the direction of an area.
 */
public final class TrafficChecker {
  /** A step is looked at so often to see which areas it leads through. */
  private static final int PIECES = 20;

  private static final double ROUNDING = 1e-6;

  private final OccupancyGrid grid;
  private final MotionModel model;

  public TrafficChecker(OccupancyGrid grid, MotionModel model) {
    this.grid = grid;
    this.model = model;
  }

  /** A rule broken by one robot or, where two were in it, by the first of them. */
  public record Violation(Rule rule, int robot, Cell cell) {}

  public enum Rule {
    ON_A_FREE_CELL,
    A_STEP_OF_THE_MODEL,
    ALONE_ON_ITS_CELL,
    NO_CHANGING_PLACES,
    NOT_AGAINST_A_DIRECTION
  }

  /**
   * @param before the robots' poses at a step, in a fixed order
   * @param after their poses one step later
   */
  public List<Violation> check(List<GridPose> before, List<GridPose> after) {
    List<Violation> violations = new ArrayList<>(checkPlaces(after));
    Map<Cell, Integer> standing = new HashMap<>();
    for (int robot = 0; robot < before.size(); robot++) {
      standing.put(before.get(robot).cell(), robot);
    }
    for (int robot = 0; robot < after.size(); robot++) {
      GridPose from = before.get(robot);
      GridPose to = after.get(robot);
      if (!isStep(from, to)) {
        violations.add(new Violation(Rule.A_STEP_OF_THE_MODEL, robot, to.cell()));
      }
      if (isAgainstDirection(from.cell(), to.cell())) {
        violations.add(new Violation(Rule.NOT_AGAINST_A_DIRECTION, robot, to.cell()));
      }
      Integer other = standing.get(to.cell());
      if (other != null && robot < other && after.get(other).cell().equals(from.cell())) {
        violations.add(new Violation(Rule.NO_CHANGING_PLACES, robot, to.cell()));
      }
    }
    return violations;
  }

  /** Only what can be said of one moment. */
  public List<Violation> checkPlaces(List<GridPose> stances) {
    List<Violation> violations = new ArrayList<>();
    Map<Cell, Integer> standing = new HashMap<>();
    for (int robot = 0; robot < stances.size(); robot++) {
      Cell cell = stances.get(robot).cell();
      if (!grid.isFree(cell)) {
        violations.add(new Violation(Rule.ON_A_FREE_CELL, robot, cell));
      }
      Integer other = standing.putIfAbsent(cell, robot);
      if (other != null) {
        violations.add(new Violation(Rule.ALONE_ON_ITS_CELL, other, cell));
      }
    }
    return violations;
  }

  /** By the areas as they are drawn, at points of the step. */
  private boolean isAgainstDirection(Cell from, Cell to) {
    Vec2 start = grid.centre(from);
    Vec2 way = grid.centre(to).minus(start);
    for (int piece = 0; piece <= PIECES; piece++) {
      Vec2 point = start.plus(way.times((double) piece / PIECES));
      for (OneWay one : grid.rules().oneWay()) {
        if (along(way, one) < -ROUNDING && isIn(one.area(), point)) {
          return true;
        }
      }
      for (OneWay one : grid.rules().approaches()) {
        if (along(way, one) < way.norm() - ROUNDING
            && isIn(one.area(), point)
            && !isIn(one.area(), start)) {
          return true;
        }
      }
    }
    return false;
  }

  private static double along(Vec2 way, OneWay one) {
    return way.x() * one.direction().vector().x() + way.y() * one.direction().vector().y();
  }

  private static boolean isIn(Area area, Vec2 point) {
    return point.x() > area.low().x() + ROUNDING
        && point.y() > area.low().y() + ROUNDING
        && point.x() < area.high().x() - ROUNDING
        && point.y() < area.high().y() - ROUNDING;
  }

  private boolean isStep(GridPose from, GridPose to) {
    int columns = to.cell().column() - from.cell().column();
    int rows = to.cell().row() - from.cell().row();
    int cells = Math.abs(columns) + Math.abs(rows);
    return switch (model) {
      case CLASSIC -> cells <= 1;
      case TURNS -> {
        Heading heading = from.heading();
        int eighths = Math.floorMod(to.heading().ordinal() - heading.ordinal(), 8);
        boolean isQuarter = eighths == 2 || eighths == 6;
        boolean isForward = columns == heading.dColumn() && rows == heading.dRow();
        yield cells == 0 ? eighths == 0 || isQuarter : cells == 1 && isForward && eighths == 0;
      }
    };
  }
}
