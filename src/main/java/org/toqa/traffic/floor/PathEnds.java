package org.toqa.traffic.floor;

import java.util.function.Predicate;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.MoveRules;
import org.toqa.grid.OccupancyGrid;

/** The cells in which a robot's path over cells begins and ends. */
final class PathEnds {
  /** So many cells beside the robot and its goal its path over cells may begin and end. */
  private static final int BESIDE = 2;

  private final FreeSpace freeSpace;

  PathEnds(FreeSpace freeSpace) {
    this.freeSpace = freeSpace;
  }

  /**
   * The cell in which its path over cells begins: where it is, or beside that where the middle of
   * its cell is too near to something, or lies against the direction of an area.
   */
  Cell entry(OccupancyGrid free, TrafficRobot robot) {
    Cell here = robot.committedCell();
    return freeSpace.seenBy(robot).freeCells(robot.radius()).isFree(here)
            && isOpen(free, here)
            && isInDirection(robot, here)
        ? here
        : nearestCell(
            robot.committedEnd().position(),
            here,
            c -> !c.equals(here) && free.isFree(c) && isInDirection(robot, c));
  }

  /** Who has its goal a little behind it, against a direction, begins ahead and comes round. */
  private boolean isInDirection(TrafficRobot robot, Cell cell) {
    OccupancyGrid grid = freeSpace.grid();
    MoveRules rules = grid.rules();
    if (!rules.isDirected()) {
      return true;
    }
    Vec2 from = robot.committedEnd().position();
    Vec2 goal = robot.goal();
    double nearby = BESIDE * grid.resolution();
    boolean isGoalBehind =
        goal != null
            && from.distanceTo(goal) < nearby
            && rules.metresAgainst(from, goal) > MoveRules.SLACK;
    return isGoalBehind
        ? !cell.equals(robot.goalCell()) && rules.allows(from, grid.centre(cell))
        : rules.metresAgainst(from, grid.centre(cell)) <= MoveRules.SLACK;
  }

  private static boolean isOpen(OccupancyGrid free, Cell cell) {
    return free.isFree(cell.column() + 1, cell.row())
        || free.isFree(cell.column() - 1, cell.row())
        || free.isFree(cell.column(), cell.row() + 1)
        || free.isFree(cell.column(), cell.row() - 1);
  }

  /** The cell in which its path over cells ends: that of the goal, or beside it likewise. */
  Cell exit(OccupancyGrid free, TrafficRobot robot, Cell goal) {
    Vec2 point = robot.goal();
    boolean isFine = LaneGrid.side(freeSpace.grid(), 2 * robot.radius()) > 1;
    return isFine && !free.isFree(goal) && point != null && goal.equals(robot.goalCell())
        ? nearestCell(point, goal, free::isFree)
        : goal;
  }

  /** The cell nearest to a point, of those beside its cell that are right; else that one itself. */
  private Cell nearestCell(Vec2 point, Cell here, Predicate<Cell> isRight) {
    return freeSpace.grid().cellsAround(point, BESIDE).stream()
        .filter(isRight)
        .findFirst()
        .orElse(here);
  }
}
