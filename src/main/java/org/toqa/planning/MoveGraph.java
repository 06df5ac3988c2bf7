package org.toqa.planning;

import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * Which of the eight moves each cell of a grid allows: a move needs a free target, a diagonal one
 * also both cells beside it (the MovingAI rule). One bit a {@link Heading}, by its ordinal; moves
 * are symmetric. Immutable.
 */
final class MoveGraph {
  private final OccupancyGrid grid;
  private final int width;
  private final byte[] moves;
  private final int[] offset = new int[8];

  MoveGraph(OccupancyGrid grid) {
    this.grid = grid;
    width = grid.width();
    for (Heading h : Heading.values()) {
      offset[h.ordinal()] = h.dRow() * width + h.dColumn();
    }
    moves = new byte[width * grid.height()];
    boolean[][] free = new boolean[grid.height() + 2][width + 2]; // with a blocked border
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < width; column++) {
        free[row + 1][column + 1] = grid.isFree(column, row);
      }
    }
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < width; column++) {
        moves[row * width + column] = (byte) mask(free, row + 1, column + 1);
      }
    }
  }

  private static int mask(boolean[][] free, int row, int column) {
    if (!free[row][column]) {
      return 0;
    }
    int east = free[row][column + 1] ? 1 : 0;
    int north = free[row - 1][column] ? 1 : 0;
    int west = free[row][column - 1] ? 1 : 0;
    int south = free[row + 1][column] ? 1 : 0;
    int northEast = free[row - 1][column + 1] ? east & north : 0;
    int northWest = free[row - 1][column - 1] ? west & north : 0;
    int southWest = free[row + 1][column - 1] ? west & south : 0;
    int southEast = free[row + 1][column + 1] ? east & south : 0;
    return east
        | northEast << 1
        | north << 2
        | northWest << 3
        | west << 4
        | southWest << 5
        | south << 6
        | southEast << 7;
  }

  OccupancyGrid grid() {
    return grid;
  }

  int size() {
    return moves.length;
  }

  /** The moves of a cell as bits by heading. */
  int moves(int cell) {
    return moves[cell] & 0xFF;
  }

  /** The cell that a move leads to. */
  int target(int cell, int heading) {
    return cell + offset[heading];
  }

  static int cost(int heading) {
    return (heading & 1) == 0 ? MoveCost.STRAIGHT : MoveCost.DIAGONAL;
  }

  int column(int cell) {
    return cell % width;
  }

  int row(int cell) {
    return cell / width;
  }

  Cell cell(int index) {
    return grid.cell(index);
  }
}
