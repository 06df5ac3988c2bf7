package org.toqa.planning;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.function.IntPredicate;
import java.util.stream.Stream;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.RandomGrids.Query;

/** Maps of the kinds that planners are compared on, always the same ones, and ways over them. */
final class OwnMaps {
  private static final int SIDE = 65;
  private static final int WAYS = 40;

  private OwnMaps() {}

  /** From free cells to free cells that can be reached from there. */
  static Stream<Query> queries() {
    Random random = new Random(1);
    return Stream.of(strewn(random), rooms(random), warehouse())
        .flatMap(grid -> ways(grid, random).stream());
  }

  private static List<Query> ways(OccupancyGrid grid, Random random) {
    List<Query> ways = new ArrayList<>();
    while (ways.size() < WAYS) {
      Cell start = grid.cell(random.nextInt(SIDE * SIDE));
      Cell goal = grid.cell(random.nextInt(SIDE * SIDE));
      if (ReferenceSearch.shortest(grid, start, goal, ReferenceSearch.FREE).isPresent()) {
        ways.add(new Query(grid, start, goal));
      }
    }
    return ways;
  }

  private static OccupancyGrid strewn(Random random) {
    return grid(cell -> random.nextInt(10) == 0);
  }

  /** Thin walls every 16 cells; a doorway of two cells in each side of each room. */
  private static OccupancyGrid rooms(Random random) {
    int[] doorways = random.ints(2 * SIDE, 1, 14).toArray();
    return grid(
        cell -> {
          int column = cell % SIDE;
          int row = cell / SIDE;
          int inColumn = column % 16 - doorways[row / 16 * 9 + column / 16];
          int inRow = row % 16 - doorways[SIDE + row / 16 * 9 + column / 16];
          boolean isDoorInRow = row % 16 == 0 && (inColumn == 0 || inColumn == 1);
          boolean isDoorInColumn = column % 16 == 0 && (inRow == 0 || inRow == 1);
          return (row % 16 == 0 || column % 16 == 0) && !isDoorInRow && !isDoorInColumn;
        });
  }

  /** Shelves of 10 by 2 cells, with aisles of 2. */
  private static OccupancyGrid warehouse() {
    return grid(cell -> cell % SIDE % 12 > 1 && cell / SIDE % 4 > 1);
  }

  private static OccupancyGrid grid(IntPredicate isOccupied) {
    BitSet occupied = new BitSet();
    for (int cell = 0; cell < SIDE * SIDE; cell++) {
      occupied.set(cell, isOccupied.test(cell));
    }
    return new OccupancyGrid(SIDE, SIDE, 1, Vec2.ZERO, occupied);
  }
}
