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
 * A store of chance with its boxes, stations and where its robots begin.
 *
 * @param store 100 x 100 m in cells of 10 x 10 m
 * @param floor the same in cells of 1 m
 * @param stations metres
 * @param starts of the supervisor and its two workers, metres
 */
record CarryingScene(
    OccupancyGrid store,
    OccupancyGrid floor,
    List<Box> boxes,
    List<Vec2> stations,
    List<Vec2> starts) {
  private static final int FINE = 10;

  /** Where robots begin, from the corner of a cell of the store: more than D_s apart. */
  private static final Vec2[] STARTS = {new Vec2(5.5, 8.5), new Vec2(1.5, 1.5), new Vec2(8.5, 1.5)};

  /**
   * @param place metres
   * @param target metres
   */
  record Box(Vec2 place, Vec2 target, double kilograms) {}

  /**
   * @param density share of the store's cells that are occupied
   * @param heavy share of the boxes that weigh more than the threshold
   */
  static CarryingScene of(
      double density, int boxes, double heavy, double threshold, SplittableRandom random) {
    while (true) {
      BitSet occupied = new BitSet();
      for (int i = 0; i < StoreScene.SIDE * StoreScene.SIDE; i++) {
        occupied.set(i, random.nextDouble() < density);
      }
      OccupancyGrid store =
          new OccupancyGrid(StoreScene.SIDE, StoreScene.SIDE, StoreScene.CELL, Vec2.ZERO, occupied);
      List<Cell> cells = connected(store, random);
      if (cells.size() >= 3 + 2 * boxes) {
        return of(store, cells, boxes, heavy, threshold, random);
      }
    }
  }

  /** The free cells that can be reached from one of them, in an order of chance. */
  private static List<Cell> connected(OccupancyGrid store, SplittableRandom random) {
    List<Cell> cells = new ArrayList<>();
    for (int i = 0; i < store.width() * store.height(); i++) {
      if (store.isFree(store.cell(i))) {
        cells.add(random.nextInt(cells.size() + 1), store.cell(i));
      }
    }
    StepLattice lattice = StepLattice.ofCells(store);
    cells.removeIf(
        cell ->
            !cell.equals(cells.getFirst())
                && !(LatticeAStar.plan(lattice, cells.getFirst(), cell)
                    instanceof LatticeResult.Found));
    return cells;
  }

  private static CarryingScene of(
      OccupancyGrid store,
      List<Cell> cells,
      int count,
      double heavy,
      double threshold,
      SplittableRandom random) {
    List<Box> boxes = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      boolean isHeavy = random.nextDouble() < heavy;
      double kilograms = threshold * (isHeavy ? 1.1 : 0.1) + random.nextDouble(0.9 * threshold);
      boxes.add(
          new Box(
              middle(store, cells.get(3 + 2 * i)), middle(store, cells.get(4 + 2 * i)), kilograms));
    }
    Vec2 corner = store.centre(cells.getFirst()).minus(new Vec2(5, 5));
    return new CarryingScene(
        store,
        fine(store),
        boxes,
        List.of(middle(store, cells.get(1)), middle(store, cells.get(2))),
        List.of(corner.plus(STARTS[0]), corner.plus(STARTS[1]), corner.plus(STARTS[2])));
  }

  /** The middle of the fine cell beside the middle of a cell of the store. */
  private static Vec2 middle(OccupancyGrid store, Cell cell) {
    return store.centre(cell).plus(new Vec2(0.5, 0.5));
  }

  private static OccupancyGrid fine(OccupancyGrid store) {
    int side = StoreScene.SIDE * FINE;
    BitSet occupied = new BitSet();
    for (int i = 0; i < side * side; i++) {
      occupied.set(i, !store.isFree(i % side / FINE, i / side / FINE));
    }
    return new OccupancyGrid(side, side, StoreScene.CELL / FINE, Vec2.ZERO, occupied);
  }
}
