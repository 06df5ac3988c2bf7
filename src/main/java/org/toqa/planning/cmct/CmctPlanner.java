package org.toqa.planning.cmct;

import java.util.ArrayList;
import java.util.List;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;
import org.toqa.planning.Path;
import org.toqa.planning.Path.Step;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanResult;

/**
 * CMCT-PP from cell to cell, with the moves of {@code planning.JumpPointSearch}: {@link CmctWalk}
 * with steps of one cell. Its path is not the shortest where it goes round obstacles.
 */
public final class CmctPlanner implements PathPlanner {

  @Override
  public PlanResult plan(OccupancyGrid grid, Cell start, Cell goal) {
    return switch (CmctWalk.plan(StepLattice.ofCells(grid), start, goal)) {
      case LatticeResult.Found found -> new PlanResult.Found(path(found.points()));
      case LatticeResult.NotFound none ->
          switch (none.reason()) {
            case START_BLOCKED -> new PlanResult.NotFound(PlanResult.Reason.START_BLOCKED, start);
            case GOAL_BLOCKED -> new PlanResult.NotFound(PlanResult.Reason.GOAL_BLOCKED, goal);
            case NO_PATH -> new PlanResult.NotFound(PlanResult.Reason.NO_PATH, goal);
            case GAVE_UP -> new PlanResult.NotFound(PlanResult.Reason.GAVE_UP, goal);
          };
    };
  }

  private static Path path(List<Cell> cells) {
    List<Step> steps = new ArrayList<>();
    double cost = 0;
    Heading heading = Heading.EAST;
    for (int i = 1; i < cells.size(); i++) {
      Cell from = cells.get(i - 1);
      int columns = cells.get(i).column() - from.column();
      int rows = cells.get(i).row() - from.row();
      heading = Heading.of(columns, rows);
      steps.add(new Step(from, heading));
      cost += Math.hypot(columns, rows);
    }
    steps.add(new Step(cells.getLast(), heading));
    return new Path(steps, cost, 0);
  }
}
