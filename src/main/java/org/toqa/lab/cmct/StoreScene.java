package org.toqa.lab.cmct;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.cmct.LatticeAStar;
import org.toqa.planning.cmct.LatticeResult;
import org.toqa.planning.cmct.StepLattice;

/**
 * A store of chance with tasks for one robot, which does them one after the other.
 *
 * @param grid 100 x 100 m in cells of 10 x 10 m
 * @param places the cell where the robot begins, then of each task that of the box and its target;
 *     each can be reached from the one before it, and is another one
 */
record StoreScene(OccupancyGrid grid, List<Cell> places) {
  /** Cells on a side, as published. */
  static final int SIDE = 10;

  /** Metres, as published. */
  static final double CELL = 10;

  /**
   * @param density share of the cells that are occupied
   */
  static StoreScene of(double density, int tasks, SplittableRandom random) {
    BitSet occupied = new BitSet();
    for (int i = 0; i < SIDE * SIDE; i++) {
      occupied.set(i, random.nextDouble() < density);
    }
    Cell start = cell(random);
    occupied.clear(start.row() * SIDE + start.column());
    OccupancyGrid grid = new OccupancyGrid(SIDE, SIDE, CELL, Vec2.ZERO, occupied);
    List<Cell> places = new ArrayList<>(List.of(start));
    while (places.size() < 1 + 2 * tasks) {
      Cell next = cell(random);
      if (isReached(grid, places.getLast(), next)) {
        places.add(next);
      } else if (isAlone(grid, start)) {
        return of(density, tasks, random);
      }
    }
    return new StoreScene(grid, List.copyOf(places));
  }

  private static Cell cell(SplittableRandom random) {
    return new Cell(random.nextInt(SIDE), random.nextInt(SIDE));
  }

  private static boolean isReached(OccupancyGrid grid, Cell from, Cell to) {
    return !from.equals(to)
        && LatticeAStar.plan(StepLattice.ofCells(grid), from, to) instanceof LatticeResult.Found;
  }

  private static boolean isAlone(OccupancyGrid grid, Cell cell) {
    return !grid.isFree(cell.column() + 1, cell.row())
        && !grid.isFree(cell.column() - 1, cell.row())
        && !grid.isFree(cell.column(), cell.row() + 1)
        && !grid.isFree(cell.column(), cell.row() - 1);
  }
}
