package org.toqa.traffic.floor;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Cell;
import org.toqa.grid.Direction;
import org.toqa.grid.MoveRules;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.OneWay;
import org.toqa.grid.SpeedLimit;

/** Areas by chance, such as leave a way from any cell to any other. */
final class DrawnAreas {
  private static final int TRIES = 12;

  private DrawnAreas() {}

  /** On every other floor; where there is one way only nobody can turn back in an aisle. */
  static MoveRules of(OccupancyGrid grid, List<Cell> free, Random random) {
    List<OneWay> kept = new ArrayList<>();
    if (random.nextBoolean()) {
      return MoveRules.NONE;
    }
    for (int i = 0; i < TRIES && kept.size() < 3; i++) {
      List<OneWay> tried = new ArrayList<>(kept);
      Direction direction = Direction.values()[random.nextInt(4)];
      tried.add(new OneWay(area(grid, random), direction));
      if (isAllReached(free, tried, grid, true) && isAllReached(free, tried, grid, false)) {
        kept = tried;
      }
    }
    return new MoveRules(kept, List.of(), List.of(new SpeedLimit(area(grid, random), 0.1)));
  }

  /** The same on a floor that is larger and lies elsewhere. */
  static MoveRules scaled(MoveRules rules, double by, Vec2 corner) {
    return new MoveRules(
        rules.oneWay().stream()
            .map(one -> new OneWay(scaled(one.area(), by, corner), one.direction()))
            .toList(),
        List.of(),
        rules.speedLimits().stream()
            .map(slow -> new SpeedLimit(scaled(slow.area(), by, corner), slow.speed()))
            .toList());
  }

  private static Area scaled(Area area, double by, Vec2 corner) {
    return new Area(corner.plus(area.low().times(by)), area.width() * by, area.height() * by);
  }

  private static Area area(OccupancyGrid grid, Random random) {
    double side = grid.resolution();
    boolean isLong = random.nextBoolean();
    int columns = isLong ? 2 + random.nextInt(5) : 1 + random.nextInt(2);
    int rows = isLong ? 1 + random.nextInt(2) : 2 + random.nextInt(5);
    Vec2 low = new Vec2(random.nextInt(grid.width()), random.nextInt(grid.height())).times(side);
    return new Area(low.plus(grid.origin()), columns * side, rows * side);
  }

  /** Whether all cells are reached from the first, or the first from all. */
  private static boolean isAllReached(
      List<Cell> free, List<OneWay> areas, OccupancyGrid grid, boolean forward) {
    Set<Cell> unseen = new HashSet<>(free);
    Deque<Cell> next = new ArrayDeque<>(List.of(free.getFirst()));
    unseen.remove(free.getFirst());
    while (!next.isEmpty()) {
      Cell cell = next.remove();
      for (Direction d : Direction.values()) {
        int east = (int) d.vector().x();
        int north = (int) d.vector().y();
        Cell beside = new Cell(cell.column() + east, cell.row() - north);
        Direction driven = Direction.values()[forward ? d.ordinal() : (d.ordinal() + 2) % 4];
        if (unseen.contains(beside)
            && areas.stream().noneMatch(a -> isAgainst(a, driven, grid, cell, beside))) {
          unseen.remove(beside);
          next.add(beside);
        }
      }
    }
    return unseen.isEmpty();
  }

  private static boolean isAgainst(
      OneWay one, Direction driven, OccupancyGrid grid, Cell a, Cell b) {
    return driven.ordinal() == (one.direction().ordinal() + 2) % 4
        && (isIn(one.area(), grid.centre(a)) || isIn(one.area(), grid.centre(b)));
  }

  private static boolean isIn(Area area, Vec2 point) {
    Vec2 inside = point.minus(area.low());
    return inside.x() > 0
        && inside.x() < area.width()
        && inside.y() > 0
        && inside.y() < area.height();
  }
}
