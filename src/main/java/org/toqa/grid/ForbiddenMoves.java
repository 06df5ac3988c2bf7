package org.toqa.grid;

import org.toqa.geometry.Vec2;

/**
 * Which of the eight moves from the middle of a cell to that of one beside it {@link MoveRules}
 * forbid: bits by direction, counter-clockwise from east in steps of 45 degrees. Two bytes a cell
 * where there are such rules, nothing else. Immutable.
 */
final class ForbiddenMoves {
  static final ForbiddenMoves NONE = new ForbiddenMoves(new byte[0], new byte[0]);

  private static final int[] COLUMNS = {1, 1, 0, -1, -1, -1, 0, 1};
  private static final int[] ROWS = {0, -1, -1, -1, 0, 1, 1, 1};

  private final byte[] from;
  private final byte[] into;

  private ForbiddenMoves(byte[] from, byte[] into) {
    this.from = from;
    this.into = into;
  }

  static ForbiddenMoves of(OccupancyGrid grid, MoveRules rules) {
    if (!rules.isDirected()) {
      return NONE;
    }
    byte[] from = new byte[grid.width() * grid.height()];
    byte[] into = new byte[from.length];
    for (Area area : rules.directedAreas()) {
      Cell first = grid.cellAt(area.low());
      Cell last = grid.cellAt(area.high());
      for (int row = Math.max(0, last.row() - 1);
          row <= Math.min(grid.height() - 1, first.row() + 1);
          row++) {
        for (int column = Math.max(0, first.column() - 1);
            column <= Math.min(grid.width() - 1, last.column() + 1);
            column++) {
          findForbidden(grid, rules, new Cell(column, row), from, into);
        }
      }
    }
    return new ForbiddenMoves(from, into);
  }

  private static void findForbidden(
      OccupancyGrid grid, MoveRules rules, Cell cell, byte[] from, byte[] into) {
    Vec2 middle = grid.centre(cell);
    for (int direction = 0; direction < COLUMNS.length; direction++) {
      Cell next = new Cell(cell.column() + COLUMNS[direction], cell.row() + ROWS[direction]);
      if (grid.contains(next) && !rules.allows(middle, grid.centre(next))) {
        from[grid.index(cell)] |= (byte) (1 << direction);
        into[grid.index(next)] |= (byte) (1 << (direction + 4 & 7));
      }
    }
  }

  /** Of the moves from a cell. */
  int from(int cell) {
    return from.length == 0 ? 0 : from[cell] & 0xFF;
  }

  /** Of the moves to a cell, by the direction in which they come from beside it. */
  int into(int cell) {
    return into.length == 0 ? 0 : into[cell] & 0xFF;
  }
}
