package org.toqa.fleet;

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
import org.toqa.traffic.floor.Group;

/**
 * Finds places round a load where all its robots can stand: {@link Shape#around}, turned east,
 * north, west or south until every place is clear of walls, each moved to the middle of a cell so
 * that no two robots touch the same one. A function of its arguments: a restarted server finds the
 * same.
 */
final class FormationPlaces {
  private static final int QUARTERS = 4;

  /** Cells beside the ideal place that are looked at. */
  private static final int BESIDE = 2;

  /** Metres of air between a robot and the load at least. */
  private static final double AIR = 0.01;

  private final OccupancyGrid grid;

  FormationPlaces(OccupancyGrid grid) {
    this.grid = grid;
  }

  /**
   * @param object where the load is, metres, map frame
   * @param radius of the largest robot, metres
   * @return empty where there is no room for them, whichever way the load faces
   */
  Optional<Formation> round(Vec2 object, int robots, @Nullable LoadSize said, double radius) {
    LoadSize size = said == null ? Formation.USUAL_SIZE : said;
    Shape ideal = Shape.around(robots, size.length(), size.width(), radius);
    for (int quarter = 0; quarter < QUARTERS; quarter++) {
      Pose load = new Pose(object.x(), object.y(), quarter * Math.PI / 2);
      Optional<Shape> shape = onCells(ideal, load, size, radius);
      if (shape.isPresent()) {
        Group group = new Group(shape.get(), radius, size.length(), size.width());
        return Optional.of(new Formation(shape.get(), load, size, group));
      }
    }
    return Optional.empty();
  }

  private Optional<Shape> onCells(Shape ideal, Pose load, LoadSize size, double radius) {
    List<Vec2> wanted = new ArrayList<>(ideal.followers());
    wanted.addFirst(ideal.leader());
    Set<Cell> taken = new HashSet<>();
    List<Vec2> places = new ArrayList<>();
    for (Vec2 place : wanted) {
      Vec2 found = nearest(place, load, size, radius, taken);
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
  private @Nullable Vec2 nearest(
      Vec2 place, Pose load, LoadSize size, double radius, Set<Cell> taken) {
    Cell middle = grid.cellAt(load.compose(new Pose(place.x(), place.y(), 0)).position());
    Vec2 best = null;
    for (int row = -BESIDE; row <= BESIDE; row++) {
      for (int column = -BESIDE; column <= BESIDE; column++) {
        Cell cell = new Cell(middle.column() + column, middle.row() + row);
        Vec2 onMap = grid.centre(cell);
        Pose seen = load.relative(new Pose(onMap.x(), onMap.y(), load.theta()));
        Vec2 candidate = seen.position();
        boolean isRight =
            gap(candidate, size) >= radius + AIR
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
