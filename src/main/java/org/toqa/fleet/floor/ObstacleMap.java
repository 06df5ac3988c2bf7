package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorView.SeenObstacle;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.CellRuns;
import org.toqa.grid.OccupancyGrid;

/**
 * Obstacles on a floor that its map does not show, as far as robots have seen it.
 *
 * <p>A percept marks the cell that it lies in; cells that touch are one obstacle. A cell is
 * forgotten {@link #REMEMBER_FOR} after it was last seen: robots go round it and so stop looking,
 * and nothing else would ever open the floor again where something was carried away. What still is
 * still there is seen once more by the next robot that comes near, at the price of a new plan.
 *
 * <p>What one robot alone has seen in one place for {@link #BELIEVE_ONE_FOR} is doubted: others may
 * drive there again, and see for themselves. If one of them sees it too, both are believed anew.
 *
 * <p>It knows no clock: time is handed in.
 */
public final class ObstacleMap {
  public static final Duration REMEMBER_FOR = Duration.ofSeconds(30);
  public static final Duration BELIEVE_ONE_FOR = Duration.ofMinutes(10);

  /** So many cells of one robot are kept at most; one that sees more sees nothing sensible. */
  static final int MAX_CELLS = 100;

  /** Metres that what is seen may be away from where it is. */
  private static final double MAX_ERROR = 0.02;

  /** Metres; what a robot sees so near to what it saw already is in one place with that. */
  private static final double SAME_PLACE = 1;

  private final OccupancyGrid grid;

  /** By {@link OccupancyGrid#index}. */
  private final Map<Integer, Mark> marks = new LinkedHashMap<>();

  /** What people were told of. */
  private final Set<Obstacle> doubted = new HashSet<>();

  /**
   * @param cell the first of it that was seen
   * @param seenBy the robot that saw it first
   */
  record Obstacle(Cell cell, String seenBy, Instant since) {}

  /**
   * @param since when the robot first saw something in this place, without a pause since
   */
  private record Sighting(Instant since, Instant last) {}

  /**
   * @param sightings by the robot; at least one
   */
  private record Mark(Cell cell, Obstacle obstacle, Map<String, Sighting> sightings) {
    boolean isBelieved() {
      return sightings.size() > 1
          || sightings.values().stream()
              .anyMatch(s -> Duration.between(s.since(), s.last()).compareTo(BELIEVE_ONE_FOR) < 0);
    }
  }

  ObstacleMap(OccupancyGrid grid) {
    this.grid = grid;
  }

  /**
   * Takes in what a robot sees. Points off the map, in walls, and as near to these as sensors and
   * odometry are wrong, say nothing new.
   *
   * @param percepts metres, map frame
   * @param isOthers whether another robot has the cell of that {@link OccupancyGrid#index}: what is
   *     seen there is that one
   * @return the obstacles that were not known before
   */
  List<Obstacle> addPercepts(
      String robot, List<Vec2> percepts, IntPredicate isOthers, Instant now) {
    List<Obstacle> appeared = new ArrayList<>();
    long ownCells = marks.values().stream().filter(m -> m.sightings().containsKey(robot)).count();
    for (Vec2 percept : percepts) {
      Cell cell = grid.cellAt(percept);
      if (!isOffWalls(percept) || isOthers.test(grid.index(cell))) {
        continue;
      }
      Mark known = marks.get(grid.index(cell));
      if (known != null && known.sightings().containsKey(robot)) {
        see(known, robot, now);
      } else if (ownCells < MAX_CELLS) {
        ownCells++;
        Optional<Obstacle> touched =
            known == null ? adjacentObstacle(cell) : Optional.of(known.obstacle());
        Obstacle obstacle = touched.orElseGet(() -> new Obstacle(cell, robot, now));
        Mark mark = known == null ? new Mark(cell, obstacle, new LinkedHashMap<>()) : known;
        see(mark, robot, now);
        marks.put(grid.index(cell), mark);
        if (touched.isEmpty()) {
          appeared.add(obstacle);
        }
      }
    }
    return appeared;
  }

  private void see(Mark mark, String robot, Instant now) {
    Sighting own = mark.sightings().get(robot);
    Instant since = own == null ? beginInPlace(mark.cell(), robot, now) : own.since();
    if (own == null) { // others were right
      mark.sightings().replaceAll((_, other) -> new Sighting(now, other.last()));
    }
    mark.sightings().put(robot, new Sighting(since, now));
  }

  /** Since when the robot sees something there or near. */
  private Instant beginInPlace(Cell cell, String robot, Instant now) {
    Vec2 there = grid.centre(cell);
    return marks.values().stream()
        .filter(mark -> grid.centre(mark.cell()).distanceTo(there) <= SAME_PLACE)
        .flatMap(mark -> Stream.ofNullable(mark.sightings().get(robot)))
        .map(Sighting::since)
        .min(Instant::compareTo)
        .orElse(now);
  }

  /** Forgets what was not seen for long, and answers the obstacles of which nothing is left. */
  List<Obstacle> forgetExpired(Instant now) {
    List<Obstacle> gone = new ArrayList<>();
    for (Iterator<Mark> each = marks.values().iterator(); each.hasNext(); ) {
      Mark mark = each.next();
      mark.sightings().values().removeIf(s -> !s.last().plus(REMEMBER_FOR).isAfter(now));
      if (mark.sightings().isEmpty()) {
        each.remove();
        gone.add(mark.obstacle());
      }
    }
    gone.removeIf(this::isMarked);
    doubted.removeAll(gone);
    return gone.stream().distinct().toList();
  }

  /** The obstacles that have just come to be doubted. */
  List<Obstacle> takeDoubted() {
    Set<Obstacle> believed = new HashSet<>();
    marks.values().stream().filter(Mark::isBelieved).forEach(m -> believed.add(m.obstacle()));
    doubted.removeAll(believed);
    return marks.values().stream()
        .map(Mark::obstacle)
        .filter(obstacle -> !believed.contains(obstacle))
        .filter(doubted::add)
        .toList();
  }

  /** All cells that are obstructed now, as bits by {@link OccupancyGrid#index}. */
  BitSet cells() {
    BitSet cells = new BitSet();
    marks.forEach(
        (index, mark) -> {
          if (mark.isBelieved()) {
            cells.set(index);
          }
        });
    return cells;
  }

  /** Each with its age, in the order in which they were seen first. */
  List<SeenObstacle> views() {
    Map<Obstacle, List<Mark>> byObstacle = new LinkedHashMap<>();
    marks
        .values()
        .forEach(
            mark -> byObstacle.computeIfAbsent(mark.obstacle(), _ -> new ArrayList<>()).add(mark));
    return byObstacle.entrySet().stream().map(e -> view(e.getKey(), e.getValue())).toList();
  }

  private SeenObstacle view(Obstacle obstacle, List<Mark> parts) {
    BitSet cells = new BitSet();
    parts.forEach(mark -> cells.set(grid.index(mark.cell())));
    return new SeenObstacle(
        CellRuns.of(cells),
        parts.stream().flatMap(m -> m.sightings().keySet().stream()).distinct().sorted().toList(),
        obstacle.since(),
        parts.stream()
            .flatMap(mark -> mark.sightings().values().stream())
            .map(Sighting::last)
            .max(Instant::compareTo)
            .orElse(obstacle.since())
            .truncatedTo(ChronoUnit.SECONDS),
        parts.stream().noneMatch(Mark::isBelieved));
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
        @Nullable Mark mark = grid.contains(near) ? marks.get(grid.index(near)) : null;
        if (mark != null) {
          return Optional.of(mark.obstacle());
        }
      }
    }
    return Optional.empty();
  }
}
