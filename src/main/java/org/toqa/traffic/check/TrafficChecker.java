package org.toqa.traffic.check;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;

/**
 * Judges what robots did, by the rules alone: it knows no planner and uses nothing that one uses.
 *
 * <p>The rules: robots are on free cells; a step is one the model allows; no two are on one cell;
 * no two change places.
 */
public final class TrafficChecker {
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
    NO_CHANGING_PLACES
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
