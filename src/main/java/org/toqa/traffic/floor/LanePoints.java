package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntPredicate;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * Where robots pass through the cells of a grid: in the middle, or so far beside it that they keep
 * their distance from a wall on one side.
 */
final class LanePoints {
  /** A point is beside the middle by at most so much, in cells. */
  private static final double MOST = 0.2;

  /** Who is beside the middle of its goal's cell by no more than that, metres, is at its goal. */
  private static final double MOST_AT_GOAL = 0.025;

  /** Radians; lines that bend less are straight. */
  private static final double STRAIGHT = 1e-3;

  private final OccupancyGrid cells;
  private final BitSet blocked;

  /** What a wall beside a cell is too near to its middle, metres; 0 where it is not. */
  private final double lack;

  private LanePoints(OccupancyGrid cells, BitSet blocked, double lack) {
    this.cells = cells;
    this.blocked = blocked;
    this.lack = lack;
  }

  /**
   * @param blocked the cells of walls and obstacles
   * @param radius of the robots, metres
   * @param kept from walls, metres
   */
  static LanePoints of(OccupancyGrid cells, BitSet blocked, double radius, double kept) {
    double side = cells.resolution();
    double lack = radius + kept - side / 2;
    return new LanePoints(cells, blocked, Math.clamp(lack, 0, MOST * side));
  }

  /** The middles of cells. */
  static LanePoints centres(OccupancyGrid cells) {
    return new LanePoints(cells, new BitSet(), 0);
  }

  OccupancyGrid cells() {
    return cells;
  }

  /** Metres, map frame. */
  Vec2 of(Cell cell) {
    Vec2 centre = cells.centre(cell);
    return lack == 0 || isByDirectedArea(cell)
        ? centre
        : centre.plus(new Vec2(sideward(cell, 1, 0), -sideward(cell, 0, 1)).times(lack));
  }

  /** There a robot that goes across would move a little against the direction. */
  private boolean isByDirectedArea(Cell cell) {
    int index = cells.contains(cell) ? cells.index(cell) : -1;
    return index >= 0 && (cells.forbiddenFrom(index) | cells.forbiddenInto(index)) != 0;
  }

  /** 1 towards rising columns or rows, -1 away from them, 0 where both sides are alike. */
  private int sideward(Cell cell, int columns, int rows) {
    boolean isBehind = isWalled(cell, -columns, -rows);
    boolean isAhead = isWalled(cell, columns, rows);
    return isBehind == isAhead ? 0 : isBehind ? 1 : -1;
  }

  /**
   * Whether the cell beside one is blocked, or one before or behind that, as far as a robot can
   * come past it: in a corner the wall ahead is none beside.
   */
  private boolean isWalled(Cell cell, int columns, int rows) {
    int column = cell.column();
    int row = cell.row();
    for (int along = -1; along <= 1; along++) {
      boolean isOpen = along == 0 || !isBlocked(column + along * rows, row + along * columns);
      if (isOpen && isBlocked(column + columns + along * rows, row + rows + along * columns)) {
        return true;
      }
    }
    return false;
  }

  private boolean isBlocked(int column, int row) {
    return !cells.contains(column, row) || blocked.get(row * cells.width() + column);
  }

  /**
   * Where a path over cells bends or turns back, and its end; its first cell is left out.
   *
   * @param from where it begins, as an index of the cells
   * @param goal where it ends, if it ends in that cell, metres, map frame; null: as in any cell
   * @param stopsAt the indices of the cells where the robot turns on the spot
   */
  List<Waypoint> waypoints(List<Cell> path, int from, @Nullable Vec2 goal, IntPredicate stopsAt) {
    List<Waypoint> waypoints = new ArrayList<>();
    Vec2 before = of(path.get(from));
    for (int i = from + 1; i < path.size(); i++) {
      boolean isEnd = i + 1 == path.size();
      Vec2 here = isEnd ? endOf(path, goal) : of(path.get(i));
      if (isEnd) {
        waypoints.add(new Waypoint(here, false));
      } else {
        Vec2 next = i + 2 == path.size() ? endOf(path, goal) : of(path.get(i + 1));
        boolean isReversal = path.get(i + 1).equals(path.get(i - 1));
        if (isReversal || !isStraight(before, here, next)) {
          waypoints.add(new Waypoint(here, isReversal || stopsAt.test(i)));
        }
      }
      before = here;
    }
    return waypoints;
  }

  /**
   * Where a robot stops in the cell of its goal: in the middle if it shall face somehow, as where
   * it meets others; else off a wall beside it, as far as it still is at its goal. Null: it has
   * none.
   */
  @Nullable Vec2 goalPoint(TrafficRobot robot) {
    Vec2 goal = robot.goal();
    if (goal == null) {
      return null;
    }
    Cell cell = cells.cellAt(goal);
    Vec2 centre = cells.centre(cell);
    Vec2 aside = of(cell).minus(centre);
    return robot.requiredHeadingAt(goal) != null || aside.norm() == 0
        ? centre
        : centre.plus(aside.times(Math.min(1, MOST_AT_GOAL / aside.norm())));
  }

  private Vec2 endOf(List<Cell> path, @Nullable Vec2 goal) {
    Cell last = path.getLast();
    return goal != null && last.equals(cells.cellAt(goal)) ? goal : of(last);
  }

  private static boolean isStraight(Vec2 before, Vec2 here, Vec2 next) {
    double change = Angles.difference(here.minus(before).angle(), next.minus(here).angle());
    return Math.abs(change) < STRAIGHT;
  }
}
