package org.toqa.lab.cmct;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/** The cells that can be reached from one. */
final class Flood {
  private static final int[][] MOVES = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

  private Flood() {}

  /** By straight moves, those with the fewest moves first; empty where the first is not free. */
  static List<Cell> from(OccupancyGrid grid, Cell start) {
    List<Cell> reached = new ArrayList<>();
    if (!grid.isFree(start)) {
      return reached;
    }
    BitSet known = new BitSet();
    Deque<Cell> open = new ArrayDeque<>(List.of(start));
    known.set(grid.index(start));
    while (!open.isEmpty()) {
      Cell cell = open.remove();
      reached.add(cell);
      for (int[] move : MOVES) {
        Cell next = new Cell(cell.column() + move[0], cell.row() + move[1]);
        if (grid.isFree(next) && !known.get(grid.index(next))) {
          known.set(grid.index(next));
          open.add(next);
        }
      }
    }
    return reached;
  }
}
