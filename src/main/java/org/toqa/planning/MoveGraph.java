package org.toqa.planning;

import java.util.BitSet;
import org.toqa.grid.OccupancyGrid;

/**
 * Which of the eight moves each cell of a grid allows: a move needs a free target, a diagonal one
 * also both cells beside it (the MovingAI rule); and the grid's rules may forbid it in one
 * direction. One bit a {@link Heading}, by its ordinal. A byte a cell, two where there are such
 * rules. Confined to one thread at a time.
 */
final class MoveGraph {
  /** A cell among the eight around it: bits of three columns, western first, of three cells. */
  private static final int MIDDLE = bit(0, 0);

  private static final int WINDOW = 0x1FF;

  /** The moves of the cell in the middle, by such bits; a set one is free. */
  private static final byte[] MOVES_BY_WINDOW = movesByWindow();

  private final int width;
  private final byte[] moves;

  /** By the direction in which they come from beside the cell; the same where all are symmetric. */
  private final byte[] movesInto;

  private final int[] offset = new int[8];

  MoveGraph(OccupancyGrid grid) {
    width = grid.width();
    for (Heading h : Heading.values()) {
      offset[h.ordinal()] = h.dRow() * width + h.dColumn();
    }
    moves = new byte[width * grid.height()];
    movesInto = grid.rules().isDirected() ? new byte[moves.length] : moves;
    for (int row = 0; row < grid.height(); row++) {
      int window = freeInColumn(grid, 0, row);
      for (int column = 0; column < width; column++) {
        window = (window << 3 | freeInColumn(grid, column + 1, row)) & WINDOW;
        setMoves(grid, row * width + column, window);
      }
    }
  }

  private void setMoves(OccupancyGrid grid, int cell, int window) {
    byte symmetric = MOVES_BY_WINDOW[window];
    moves[cell] = symmetric;
    if (movesInto != moves) {
      moves[cell] = (byte) (symmetric & ~grid.forbiddenFrom(cell));
      movesInto[cell] = (byte) (symmetric & ~grid.forbiddenInto(cell));
    }
  }

  /**
   * Takes over a grid of the same size and rules.
   *
   * @param changed the cells that are not as before, by their index
   */
  void update(OccupancyGrid grid, BitSet changed) {
    for (int cell = changed.nextSetBit(0); cell >= 0; cell = changed.nextSetBit(cell + 1)) {
      for (int row = row(cell) - 1; row <= row(cell) + 1; row++) {
        for (int column = column(cell) - 1; column <= column(cell) + 1; column++) {
          if (grid.contains(column, row)) {
            int window =
                freeInColumn(grid, column - 1, row) << 6
                    | freeInColumn(grid, column, row) << 3
                    | freeInColumn(grid, column + 1, row);
            setMoves(grid, row * width + column, window);
          }
        }
      }
    }
  }

  /** Of three cells, the northern one first. */
  private static int freeInColumn(OccupancyGrid grid, int column, int row) {
    return (grid.isFree(column, row - 1) ? 4 : 0)
        | (grid.isFree(column, row) ? 2 : 0)
        | (grid.isFree(column, row + 1) ? 1 : 0);
  }

  private static byte[] movesByWindow() {
    byte[] table = new byte[WINDOW + 1];
    for (int window = 0; window <= WINDOW; window++) {
      for (Heading h : Heading.values()) {
        int needed = MIDDLE | bit(h.dColumn(), h.dRow()) | bit(h.dColumn(), 0) | bit(0, h.dRow());
        if ((window & needed) == needed) {
          table[window] |= (byte) (1 << h.ordinal());
        }
      }
    }
    return table;
  }

  private static int bit(int dColumn, int dRow) {
    return 1 << (4 - 3 * dColumn - dRow);
  }

  int size() {
    return moves.length;
  }

  /** The moves of a cell as bits by heading. */
  int moves(int cell) {
    return moves[cell] & 0xFF;
  }

  /** Whether there is a move that is not allowed back. */
  boolean isDirected() {
    return movesInto != moves;
  }

  /** The moves to a cell, as bits by the direction in which they come from beside it. */
  int movesInto(int cell) {
    return movesInto[cell] & 0xFF;
  }

  boolean allows(int cell, int heading) {
    return (moves[cell] >> heading & 1) == 1;
  }

  /** The cell that a move leads to. */
  int target(int cell, int heading) {
    return cell + offset[heading];
  }

  static int cost(int heading) {
    return (heading & 1) == 0 ? MoveCost.STRAIGHT : MoveCost.DIAGONAL;
  }

  int width() {
    return width;
  }

  int column(int cell) {
    return cell % width;
  }

  int row(int cell) {
    return cell / width;
  }
}
