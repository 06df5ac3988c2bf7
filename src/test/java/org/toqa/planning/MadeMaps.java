package org.toqa.planning;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Random;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;

/** Square maps of kinds that planners are compared on, of any size, by chance. */
final class MadeMaps {
  private static final int[][] SIDES = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

  private MadeMaps() {}

  /** Noise, in which each cell five times over becomes what most of those around it are. */
  static OccupancyGrid cave(int side, double density, Random random) {
    BitSet occupied = new BitSet();
    for (int cell = 0; cell < side * side; cell++) {
      occupied.set(cell, random.nextDouble() < density);
    }
    OccupancyGrid grid = grid(side, occupied);
    for (int round = 0; round < 5; round++) {
      BitSet smoother = new BitSet();
      for (int cell = 0; cell < side * side; cell++) {
        smoother.set(cell, occupiedAround(grid, cell % side, cell / side) >= 5);
      }
      grid = grid.withOccupied(smoother);
    }
    return grid;
  }

  private static int occupiedAround(OccupancyGrid grid, int column, int row) {
    int count = 0;
    for (int i = 0; i < 9; i++) {
      count += grid.isFree(column - 1 + i % 3, row - 1 + i / 3) ? 0 : 1;
    }
    return count;
  }

  /** Rooms of nine cells with thin walls; doorways of two cells in most walls. */
  static OccupancyGrid rooms(int side, Random random) {
    BitSet occupied = new BitSet();
    for (int cell = 0; cell < side * side; cell++) {
      occupied.set(cell, cell % side % 10 == 0 || cell / side % 10 == 0);
    }
    for (int row = 0; row < side; row += 10) {
      for (int column = 0; column < side; column += 10) {
        for (int doorway = 0; doorway < 2; doorway++) {
          int along = 1 + random.nextInt(7);
          boolean inRow = doorway == 0;
          if ((inRow ? row : column) == 0 || random.nextInt(5) == 0) {
            continue;
          }
          for (int cell = along; cell < along + 2; cell++) {
            free(side, occupied, inRow ? column + cell : column, inRow ? row : row + cell, 1, 1);
          }
        }
      }
    }
    return grid(side, occupied);
  }

  /** Walls of one cell; by chance in depth first, so it has long corridors. */
  static OccupancyGrid maze(int side, int corridor, Random random) {
    int pitch = corridor + 1;
    int fields = Math.max(1, (side - 1) / pitch);
    BitSet occupied = new BitSet();
    occupied.set(0, side * side);
    free(side, occupied, 1, 1, corridor, corridor);
    BitSet seen = new BitSet();
    seen.set(0);
    Deque<Integer> trail = new ArrayDeque<>(List.of(0));
    while (!trail.isEmpty()) {
      int x = trail.element() % fields;
      int y = trail.element() / fields;
      List<int[]> open = new ArrayList<>();
      for (int[] by : SIDES) {
        boolean isInside =
            Math.min(x + by[0], y + by[1]) >= 0 && Math.max(x + by[0], y + by[1]) < fields;
        if (isInside && !seen.get((y + by[1]) * fields + x + by[0])) {
          open.add(by);
        }
      }
      if (open.isEmpty()) {
        trail.pop();
        continue;
      }
      int[] by = open.get(random.nextInt(open.size()));
      int column = 1 + Math.min(x, x + by[0]) * pitch;
      int row = 1 + Math.min(y, y + by[1]) * pitch;
      int columns = corridor + Math.abs(by[0]) * pitch;
      free(side, occupied, column, row, columns, corridor + Math.abs(by[1]) * pitch);
      int next = (y + by[1]) * fields + x + by[0];
      seen.set(next);
      trail.push(next);
    }
    return grid(side, occupied);
  }

  private static void free(int side, BitSet occupied, int column, int row, int columns, int rows) {
    for (int r = row; r < Math.min(side, row + rows); r++) {
      for (int c = column; c < Math.min(side, column + columns); c++) {
        occupied.clear(r * side + c);
      }
    }
  }

  private static OccupancyGrid grid(int side, BitSet occupied) {
    return new OccupancyGrid(side, side, 1, Vec2.ZERO, occupied);
  }
}
