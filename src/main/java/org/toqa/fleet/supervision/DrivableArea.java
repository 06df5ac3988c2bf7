package org.toqa.fleet.supervision;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.TransportTask.LoadSize;

/** Where a robot's middle can be, while boxes lie on the floor. For one thread. */
final class DrivableArea {
  private static final int[][] SIDES = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

  private final OccupancyGrid floor;
  private final double clearance;
  private final OccupancyGrid withoutBoxes;

  /**
   * @param clearance metres between a robot's middle and what it keeps off
   */
  DrivableArea(FloorMap floor, double clearance) {
    this.floor = floor.grid();
    this.clearance = clearance;
    this.withoutBoxes = Inflation.inflate(this.floor, clearance);
  }

  /**
   * @param boxes that lie there, metres, map frame
   */
  OccupancyGrid among(Collection<Vec2> boxes) {
    if (boxes.isEmpty()) {
      return withoutBoxes;
    }
    Disc disc = new Disc(LoadSize.DEFAULT.diameter() / 2);
    BitSet occupied = (BitSet) floor.occupied().clone();
    boxes.forEach(box -> disc.cellsAt(floor, box).forEach(cell -> occupied.set(floor.index(cell))));
    return Inflation.inflate(floor.withOccupied(occupied), clearance);
  }

  /**
   * The cells to which there is a way.
   *
   * @param from where robots are, metres; these may stand anywhere; empty: nobody knows, and all
   *     free cells count
   */
  static BitSet reachable(OccupancyGrid grid, List<Vec2> from) {
    BitSet reached = new BitSet();
    if (from.isEmpty()) {
      reached.set(0, grid.width() * grid.height());
      reached.andNot(grid.occupied());
      return reached;
    }
    Deque<Cell> queue = new ArrayDeque<>();
    from.stream().map(grid::cellAt).filter(grid::contains).forEach(queue::add);
    queue.forEach(cell -> reached.set(grid.index(cell)));
    while (!queue.isEmpty()) {
      Cell cell = queue.remove();
      for (int[] side : SIDES) {
        Cell next = new Cell(cell.column() + side[0], cell.row() + side[1]);
        if (grid.contains(next) && grid.isFree(next) && !reached.get(grid.index(next))) {
          reached.set(grid.index(next));
          queue.add(next);
        }
      }
    }
    return reached;
  }
}
