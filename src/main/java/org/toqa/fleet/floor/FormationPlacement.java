package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.floor.FloorTraffic;
import org.toqa.traffic.floor.FormationFootprint;
import org.toqa.traffic.mapf.LacamJointPlanner;

/**
 * Finds places round a load where all its robots can be: {@link Shape#around}, turned east, north,
 * west or south until every place is clear of walls and the group has a path to the goal, each
 * place moved to the middle of a cell so that no two robots touch the same one. A function of its
 * arguments: a restarted server finds the same. Confined to one thread.
 */
final class FormationPlacement {
  private static final int QUARTERS = 4;

  /** Cells beside the ideal place that are looked at. */
  private static final int SEARCH_RADIUS = 2;

  /** Metres of air between a robot and the load at least. */
  private static final double CLEARANCE = 0.01;

  /** Cells that a place may be moved by. */
  private static final double MAX_SHIFT = 1;

  private static final String LEADER = "leader";

  private final OccupancyGrid grid;

  /** Without any other robot. */
  private final FloorTraffic empty;

  FormationPlacement(OccupancyGrid grid) {
    this.grid = grid;
    this.empty = new FloorTraffic(grid, new LacamJointPlanner(), Deadline::none);
  }

  /**
   * @param object where the load is, metres, map frame
   * @param goal where it is carried, metres, map frame
   * @param radius of the largest robot, metres
   * @return empty where there is no room for them or no path, wherever the load faces
   */
  Optional<Formation> find(
      Vec2 object, Vec2 goal, int robots, @Nullable LoadSize requestedSize, double radius) {
    LoadSize size = requestedSize == null ? LoadSize.DEFAULT : requestedSize;
    Shape ideal = Shape.around(robots, size.length(), size.width(), radius);
    for (int quarter = 0; quarter < QUARTERS; quarter++) {
      Pose load = new Pose(object.x(), object.y(), quarter * Math.PI / 2);
      Optional<Shape> shape = alignedToCells(ideal, load, size, radius);
      if (shape.isPresent()) {
        FormationFootprint group =
            new FormationFootprint(shape.get(), radius, size.length(), size.width());
        Formation formation = new Formation(shape.get(), load, size, group);
        if (hasPath(formation, goal, 2 * radius)) {
          return Optional.of(formation);
        }
      }
    }
    return Optional.empty();
  }

  private boolean hasPath(Formation formation, Vec2 goal, double footprint) {
    empty.reportStanding(LEADER, formation.pose(0), footprint, Instant.EPOCH);
    empty.setFormation(LEADER, formation.group());
    empty.setMovable(LEADER, true);
    empty.setGoal(LEADER, goal, Instant.EPOCH);
    empty.decide(Instant.EPOCH);
    boolean hasPath = empty.waitReason(LEADER) == null;
    empty.removeRobot(LEADER);
    return hasPath;
  }

  private Optional<Shape> alignedToCells(Shape ideal, Pose load, LoadSize size, double radius) {
    List<Vec2> wanted = new ArrayList<>(ideal.followers());
    wanted.addFirst(ideal.leader());
    Set<Cell> taken = new HashSet<>();
    List<Vec2> places = new ArrayList<>();
    for (Vec2 place : wanted) {
      Vec2 found = nearestStandable(place, load, size, radius, taken);
      if (found == null) {
        return Optional.empty();
      }
      places.add(found);
      Vec2 onMap = load.compose(new Pose(found.x(), found.y(), 0)).position();
      taken.addAll(new Disc(radius).cellsAt(grid, onMap));
    }
    return Optional.of(new Shape(places.getFirst(), places.subList(1, places.size())));
  }

  /** In the load's frame; null where there is none. */
  private @Nullable Vec2 nearestStandable(
      Vec2 place, Pose load, LoadSize size, double radius, Set<Cell> taken) {
    Cell middle = grid.cellAt(load.compose(new Pose(place.x(), place.y(), 0)).position());
    Vec2 best = null;
    for (int row = -SEARCH_RADIUS; row <= SEARCH_RADIUS; row++) {
      for (int column = -SEARCH_RADIUS; column <= SEARCH_RADIUS; column++) {
        Cell cell = new Cell(middle.column() + column, middle.row() + row);
        Vec2 onMap = grid.centre(cell);
        Pose seen = load.relative(new Pose(onMap.x(), onMap.y(), load.theta()));
        Vec2 candidate = seen.position();
        boolean isRight =
            gap(candidate, size) >= radius + CLEARANCE
                && candidate.distanceTo(place) <= MAX_SHIFT * grid.resolution()
                && (best == null || candidate.distanceTo(place) < best.distanceTo(place) - 1e-9)
                && new Disc(radius).isFreeAt(grid, onMap)
                && new Disc(radius).cellsAt(grid, onMap).stream().noneMatch(taken::contains);
        best = isRight ? candidate : best;
      }
    }
    return best;
  }

  /** From a point to the load's edge, metres. */
  private static double gap(Vec2 point, LoadSize size) {
    return Math.hypot(
        Math.max(0, Math.abs(point.x()) - size.length() / 2),
        Math.max(0, Math.abs(point.y()) - size.width() / 2));
  }
}
