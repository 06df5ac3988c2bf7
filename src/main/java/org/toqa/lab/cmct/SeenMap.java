package org.toqa.lab.cmct;

import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.RayCast;

/** What cameras have seen of a floor: what they have not seen is not known, and not driven on. */
final class SeenMap {
  private static final int RAYS = 360;

  private final OccupancyGrid floor;
  private final BitSet free = new BitSet();

  /** The part of it that was seen since a search began. */
  private final BitSet scanned = new BitSet();

  private final BitSet walls = new BitSet();
  private final BitSet hopeless = new BitSet();

  /** By margin, until the map grows. */
  private final Map<Double, OccupancyGrid> inflated = new HashMap<>();

  SeenMap(OccupancyGrid floor) {
    this.floor = floor;
  }

  /** All is as if nothing had ever been seen. */
  void forget() {
    free.clear();
    walls.clear();
    inflated.clear();
    scanAnew();
  }

  /** Where the floor is free is known, but not what lies on it. */
  void scanAnew() {
    scanned.clear();
    hopeless.clear();
  }

  /** Takes over where the floor is free, as another has seen it; it has not looked there itself. */
  void learn(SeenMap other) {
    free.or(other.free);
    walls.or(other.walls);
    inflated.clear();
  }

  /** Looks all round; whether there was anything new. */
  boolean look(Vec2 from, double range) {
    int before = free.cardinality() + walls.cardinality();
    int scannedBefore = scanned.cardinality();
    for (int i = 0; i < RAYS; i++) {
      double angle = 2 * Math.PI * i / RAYS;
      double seen = RayCast.distance(floor, from, angle, range);
      Vec2 along = new Vec2(Math.cos(angle), Math.sin(angle));
      for (double d = 0; d < seen; d += 0.5) {
        Cell cell = floor.cellAt(from.plus(along.times(d)));
        if (floor.isFree(cell)) {
          free.set(floor.index(cell));
          scanned.set(floor.index(cell));
        }
      }
      Cell hit = floor.cellAt(from.plus(along.times(seen + 0.01)));
      if (floor.contains(hit) && !floor.isFree(hit)) {
        walls.set(floor.index(hit));
      }
    }
    boolean hasGrown = free.cardinality() + walls.cardinality() > before;
    if (hasGrown) {
      inflated.clear();
    }
    return hasGrown || scanned.cardinality() > scannedBefore;
  }

  /** Whether a point can be seen from another one. */
  boolean isInView(Vec2 from, Vec2 point, double range) {
    Vec2 way = point.minus(from);
    return way.norm() <= range
        && RayCast.distance(floor, from, way.angle(), way.norm()) >= way.norm() - 1e-9;
  }

  /** Where the middle of something round may be. */
  OccupancyGrid passable(double radius) {
    return inflated.computeIfAbsent(
        radius,
        r -> {
          BitSet blocked = new BitSet();
          blocked.set(0, floor.width() * floor.height());
          blocked.andNot(free);
          return Inflation.inflate(floor.withOccupied(blocked), r);
        });
  }

  /** Whether a cell is seen, free, and beside one that is not seen. */
  boolean isBorder(Cell cell) {
    return isFree(cell.column(), cell.row())
        && !hopeless.get(floor.index(cell))
        && (isUnseen(cell.column() + 1, cell.row())
            || isUnseen(cell.column() - 1, cell.row())
            || isUnseen(cell.column(), cell.row() + 1)
            || isUnseen(cell.column(), cell.row() - 1));
  }

  /** There was nothing more to be seen from round a point. */
  void giveUpRound(Vec2 point, int cells) {
    for (Cell cell : floor.cellsAround(point, cells)) {
      hopeless.set(floor.index(cell));
    }
  }

  private boolean isFree(int column, int row) {
    return floor.contains(column, row) && scanned.get(row * floor.width() + column);
  }

  private boolean isUnseen(int column, int row) {
    return floor.contains(column, row)
        && !scanned.get(row * floor.width() + column)
        && !walls.get(row * floor.width() + column);
  }
}
