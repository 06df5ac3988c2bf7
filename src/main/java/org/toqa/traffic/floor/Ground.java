package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;

/** What stands fast on the floor, walls and obstacles, and where robots of a size fit. */
final class Ground {
  private final OccupancyGrid grid;
  private final BitSet walls;
  private BitSet obstacles = new BitSet();
  private BitSet closed;

  private final Map<Double, OccupancyGrid> clearOfWalls = new HashMap<>();
  private final Map<Double, OccupancyGrid> clear = new HashMap<>();
  private final Map<Double, List<Cell>> reaches = new HashMap<>();
  private final Map<Double, Lanes> lanes = new HashMap<>();

  Ground(OccupancyGrid grid) {
    this.grid = grid;
    this.walls = grid.occupied();
    this.closed = walls;
  }

  OccupancyGrid grid() {
    return grid;
  }

  /** Whether it differs from what was known. */
  boolean takeObstacles(BitSet now) {
    if (now.equals(obstacles)) {
      return false;
    }
    obstacles = (BitSet) now.clone();
    closed = (BitSet) walls.clone();
    closed.or(obstacles);
    clear.clear();
    return true;
  }

  BitSet obstacles() {
    return obstacles;
  }

  /** Walls and obstacles; not to be changed. */
  BitSet closed() {
    return closed;
  }

  /** Where the middle of a robot can be, on a floor without obstacles. */
  OccupancyGrid clearOfWalls(double radius) {
    return clearOfWalls.computeIfAbsent(radius, r -> Inflation.of(grid, r));
  }

  /** Where the middle of a robot can be. */
  OccupancyGrid clear(double radius) {
    return clear.computeIfAbsent(
        radius,
        r -> {
          OccupancyGrid free = clearOfWalls(r);
          return obstacles.isEmpty() ? free : with(free, grown(obstacles, r));
        });
  }

  /**
   * The same where more is closed.
   *
   * @param cells that it must not touch
   * @param discs of others, that it must not touch
   * @param standing the cell where it is, which never counts as closed
   */
  OccupancyGrid clear(double radius, BitSet cells, List<Round> discs, Cell standing) {
    OccupancyGrid free = clear(radius);
    if (cells.isEmpty() && discs.isEmpty() && free.isFree(standing)) {
      return free;
    }
    BitSet more = grown(cells, radius);
    for (Round disc : discs) {
      Vec2 middle = disc.middle();
      double apart = radius + disc.radius();
      SweptCells.standing(grid, middle, apart)
          .forEach(
              i ->
                  more.set(i, grid.centre(grid.cell(i)).distanceTo(middle) < apart || more.get(i)));
    }
    more.or(free.occupied());
    more.clear(grid.index(standing));
    return grid.withOccupied(more);
  }

  private OccupancyGrid with(OccupancyGrid free, BitSet more) {
    more.or(free.occupied());
    return grid.withOccupied(more);
  }

  /** The cells on whose middle a disc would touch one of these. */
  private BitSet grown(BitSet cells, double radius) {
    List<Cell> reach = reaches.computeIfAbsent(radius, this::reach);
    BitSet grown = new BitSet();
    for (int i = cells.nextSetBit(0); i >= 0; i = cells.nextSetBit(i + 1)) {
      int column = i % grid.width();
      int row = i / grid.width();
      for (Cell by : reach) {
        if (grid.contains(column + by.column(), row + by.row())) {
          grown.set(i + by.row() * grid.width() + by.column());
        }
      }
    }
    return grown;
  }

  /** The cells round one whose middle is the disc's that the disc touches, as columns and rows. */
  private List<Cell> reach(double radius) {
    int side = 2 * (int) Math.ceil(radius / grid.resolution()) + 1;
    OccupancyGrid cells = new OccupancyGrid(side, side, grid.resolution(), Vec2.ZERO, new BitSet());
    Cell middle = new Cell(side / 2, side / 2);
    List<Cell> reach = new ArrayList<>();
    for (Cell cell : new Disc(radius).cellsAt(cells, cells.centre(middle))) {
      reach.add(new Cell(cell.column() - middle.column(), cell.row() - middle.row()));
    }
    return List.copyOf(reach);
  }

  /** The floor in cells that are large enough for robots of that size. */
  Lanes lanes(double diameter) {
    return lanes.computeIfAbsent(diameter, d -> Lanes.of(grid, d));
  }
}
