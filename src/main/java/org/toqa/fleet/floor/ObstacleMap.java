package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * Obstacles on a floor that its map does not show, as far as robots have seen it.
 *
 * <p>A percept marks the cell that it lies in; cells that touch are one obstacle. A cell is
 * forgotten {@link #REMEMBER_FOR} after it was last seen: robots go round it and so stop looking,
 * and nothing else would ever open the floor again where something was carried away. What still is
 * still there is seen once more by the next robot that comes near, at the price of a new plan.
 *
 * <p>It knows no clock: time is handed in.
 */
public final class ObstacleMap {
  public static final Duration REMEMBER_FOR = Duration.ofSeconds(30);

  /** So many cells are kept at most; a robot that sees more than that sees nothing sensible. */
  static final int MAX_CELLS = 500;

  /** Metres that what is seen may be away from where it is. */
  private static final double MAX_ERROR = 0.02;

  private final OccupancyGrid grid;

  /** By {@link OccupancyGrid#index}. */
  private final Map<Integer, Mark> marks = new LinkedHashMap<>();

  /**
   * @param cell the first of it that was seen
   * @param seenBy the robot that saw it first
   */
  record Obstacle(Cell cell, String seenBy, Instant since) {}

  private record Mark(Obstacle obstacle, Instant seenLast) {}

  ObstacleMap(OccupancyGrid grid) {
    this.grid = grid;
  }

  /**
   * Takes in what a robot sees. Points off the map, in walls, and as near to these as sensors and
   * odometry are wrong, say nothing new.
   *
   * @param percepts metres, map frame
   * @param others the cells that other robots hold: what is seen there is them
   * @return the obstacles that were not known before
   */
  List<Obstacle> addPercepts(String robot, List<Vec2> percepts, BitSet others, Instant now) {
    List<Obstacle> appeared = new ArrayList<>();
    for (Vec2 percept : percepts) {
      Cell cell = grid.cellAt(percept);
      if (!isOffWalls(percept) || others.get(grid.index(cell))) {
        continue;
      }
      Mark known = marks.get(grid.index(cell));
      if (known != null) {
        marks.put(grid.index(cell), new Mark(known.obstacle(), now));
      } else if (marks.size() < MAX_CELLS) {
        Optional<Obstacle> touched = adjacentObstacle(cell);
        Obstacle obstacle = touched.orElseGet(() -> new Obstacle(cell, robot, now));
        marks.put(grid.index(cell), new Mark(obstacle, now));
        if (touched.isEmpty()) {
          appeared.add(obstacle);
        }
      }
    }
    return appeared;
  }

  /** Forgets what was not seen for long, and answers the obstacles of which nothing is left. */
  List<Obstacle> forgetExpired(Instant now) {
    List<Obstacle> gone = new ArrayList<>();
    for (Iterator<Mark> each = marks.values().iterator(); each.hasNext(); ) {
      Mark mark = each.next();
      if (!mark.seenLast().plus(REMEMBER_FOR).isAfter(now)) {
        each.remove();
        gone.add(mark.obstacle());
      }
    }
    return gone.stream().distinct().filter(obstacle -> !isMarked(obstacle)).toList();
  }

  /** All cells that are obstructed now, as bits by {@link OccupancyGrid#index}. */
  BitSet cells() {
    BitSet cells = new BitSet();
    marks.keySet().forEach(cells::set);
    return cells;
  }

  private boolean isOffWalls(Vec2 point) {
    return Stream.of(Vec2.ZERO, new Vec2(MAX_ERROR, 0), new Vec2(0, MAX_ERROR))
        .flatMap(aside -> Stream.of(point.plus(aside), point.minus(aside)))
        .allMatch(grid::isFree);
  }

  private boolean isMarked(Obstacle obstacle) {
    return marks.values().stream().anyMatch(mark -> mark.obstacle().equals(obstacle));
  }

  private Optional<Obstacle> adjacentObstacle(Cell cell) {
    for (int dColumn = -1; dColumn <= 1; dColumn++) {
      for (int dRow = -1; dRow <= 1; dRow++) {
        Cell near = new Cell(cell.column() + dColumn, cell.row() + dRow);
        Mark mark = grid.contains(near) ? marks.get(grid.index(near)) : null;
        if (mark != null) {
          return Optional.of(mark.obstacle());
        }
      }
    }
    return Optional.empty();
  }
}
