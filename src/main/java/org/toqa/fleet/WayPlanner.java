package org.toqa.fleet;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;
import org.toqa.planning.HeadingAStar;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanResult;
import org.toqa.traffic.SweptCells;

/**
 * Plans one robot's way among the others of its floor: {@code inflate -> plan -> fit -> check}.
 * Robots that stand are gone round; a robot that drives is waited for where its reserved cells and
 * this way meet.
 */
final class WayPlanner {
  private final OccupancyGrid grid;
  private final PathPlanner planner = new HeadingAStar();
  private final SegmentFitter fitter;
  private final Map<Double, OccupancyGrid> inflated = new HashMap<>();

  /**
   * Another robot of the floor.
   *
   * @param footprint diameter, metres
   * @param reserved the cells it stands on, and those of its way
   */
  record Other(String name, Vec2 position, double footprint, boolean driving, BitSet reserved) {}

  sealed interface Result {}

  record Found(Trajectory way, int turnsOnSpot) implements Result {}

  /**
   * @param sentence why there is no way now, for people
   */
  record None(String sentence) implements Result {}

  WayPlanner(OccupancyGrid grid) {
    this.grid = grid;
    this.fitter = new SegmentFitter(DriveSpeeds.DEFAULT, grid.resolution());
  }

  /**
   * @param from where the robot stands
   * @param footprint diameter, metres
   */
  Result plan(Pose from, Vec2 goal, double footprint, List<Other> others) {
    OccupancyGrid clear = inflated.computeIfAbsent(footprint, d -> Inflation.of(grid, d / 2));
    Cell start = grid.cellAt(from.position());
    Cell end = grid.cellAt(goal);
    PlanResult result = planner.plan(around(others, footprint, clear, start), start, end);
    if (!(result instanceof PlanResult.Found(var path))) {
      return new None(whyNone(planner.plan(clear, start, end), goal, others));
    }
    Trajectory way = fitter.fit(from, path.waypoints(grid));
    for (BitSet sweep : SweptCells.bySegment(grid, way, footprint / 2)) {
      for (Other other : others) {
        if (sweep.intersects(other.reserved())) {
          return new None("Waits for " + other.name() + " to pass.");
        }
      }
    }
    return new Found(way, path.turnsOnSpot());
  }

  /** The grid with the places blocked where standing robots leave no room for this one. */
  private OccupancyGrid around(
      List<Other> others, double footprint, OccupancyGrid clear, Cell start) {
    BitSet blocked = clear.occupied();
    for (Other other : others) {
      if (!other.driving()) {
        Disc both = new Disc((footprint + other.footprint()) / 2);
        both.cellsAt(grid, other.position()).forEach(c -> blockNear(blocked, c, other, both));
      }
    }
    blocked.clear(grid.index(start));
    return clear.withOccupied(blocked);
  }

  private void blockNear(BitSet blocked, Cell cell, Other other, Disc both) {
    if (grid.centre(cell).distanceTo(other.position()) < both.radius()) {
      blocked.set(grid.index(cell));
    }
  }

  private static String whyNone(PlanResult alone, Vec2 goal, List<Other> others) {
    String place = new org.toqa.mission.TaskPlace(goal, null).text();
    return switch (alone) {
      case PlanResult.NotFound(PlanResult.Reason reason, Cell where) ->
          switch (reason) {
            case START_BLOCKED -> "Stands too near to a wall to set out, at cell " + where + ".";
            case GOAL_BLOCKED -> "There is no room for it at " + place + ".";
            case NO_PATH -> "There is no way for it to " + place + ".";
          };
      case PlanResult.Found found -> {
        List<String> standing = others.stream().filter(o -> !o.driving()).map(Other::name).toList();
        yield "The way to "
            + place
            + " is blocked by standing robots: one of "
            + String.join(", ", standing)
            + ".";
      }
    };
  }
}
