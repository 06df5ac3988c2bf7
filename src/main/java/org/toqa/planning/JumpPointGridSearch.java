package org.toqa.planning;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * A* over jump points, as {@link JumpPointSearch} describes it. Flat arrays by cell; a generation
 * stamp makes them new without clearing.
 */
final class JumpPointGridSearch implements GridSearch {
  private static final int ALL_DIRECTIONS = 0xFF;
  private static final int EAST = Heading.EAST.ordinal();
  private static final int SOUTH = Heading.SOUTH.ordinal();

  /** Directions in which a shortest path may go on, by {@code 256 arrival + moves}. */
  private static final byte[] ONWARD = onward();

  private final OccupancyGrid grid;
  private final int width;
  private final MoveGraph graph;
  private final StraightRuns alongRows;
  private final StraightRuns alongColumns;
  private final int[] g;

  /** {@code 2 generation}: the cell's values are valid; {@code 2 generation + 1}: and final. */
  private final int[] stamp;

  private final int[] parent;

  /** The direction of the last move, as an ordinal of {@link Heading}. */
  private final byte[] arrival;

  private final OpenList open = new OpenList();
  private int generation;
  private int goalColumn;
  private int goalRow;
  private long expanded;

  JumpPointGridSearch(OccupancyGrid grid) {
    this.grid = grid;
    width = grid.width();
    graph = new MoveGraph(grid);
    alongRows = StraightRuns.alongRows(grid);
    alongColumns = StraightRuns.alongColumns(grid);
    g = new int[graph.size()];
    stamp = new int[graph.size()];
    parent = new int[graph.size()];
    arrival = new byte[graph.size()];
  }

  @Override
  public OccupancyGrid grid() {
    return grid;
  }

  @Override
  public long expandedCount() {
    return expanded;
  }

  @Override
  public Optional<Path> path(Cell start, Cell goal) {
    begin(goal);
    int from = grid.index(start);
    int to = grid.index(goal);
    reach(start.column(), start.row(), 0, from, EAST);
    while (!open.isEmpty()) {
      int cell = open.pop();
      if (stamp[cell] != 2 * generation + 1) {
        stamp[cell] = 2 * generation + 1;
        if (cell == to) {
          return Optional.of(Path.of(start, movesTo(to), false));
        }
        expand(cell, cell == from ? ALL_DIRECTIONS : onward(cell));
      }
    }
    return Optional.empty();
  }

  private void begin(Cell goal) {
    if (generation == Integer.MAX_VALUE / 2 - 1) {
      generation = 0;
      Arrays.fill(stamp, 0);
    }
    generation++;
    goalColumn = goal.column();
    goalRow = goal.row();
    open.clear();
  }

  private int onward(int cell) {
    return ONWARD[arrival[cell] << 8 | graph.moves(cell)];
  }

  private void expand(int cell, int directions) {
    expanded++;
    int column = graph.column(cell);
    int row = graph.row(cell);
    for (int left = directions & graph.moves(cell); left != 0; left &= left - 1) {
      int direction = Integer.numberOfTrailingZeros(left);
      if ((direction & 1) == 0) {
        runStraight(column, row, direction, g[cell], cell);
      } else {
        runDiagonally(cell, direction);
      }
    }
  }

  /** Looks to both sides of every cell of a diagonal. */
  private void runDiagonally(int from, int direction) {
    Heading heading = Heading.of(direction);
    int column = graph.column(from);
    int row = graph.row(from);
    int length = g[from];
    int cell = from;
    while ((graph.moves(cell) >> direction & 1) == 1) {
      cell = graph.target(cell, direction);
      column += heading.dColumn();
      row += heading.dRow();
      length += MoveCost.DIAGONAL;
      if (column == goalColumn && row == goalRow) {
        reach(column, row, length, from, direction);
        return;
      }
      runStraight(column, row, direction - 1, length, from);
      runStraight(column, row, direction + 1 & 7, length, from);
    }
  }

  /**
   * Reaches the jump point or the goal in a straight line, if there is one.
   *
   * @param length to the cell where the line begins
   * @param from the node from which that cell was reached
   */
  private void runStraight(int column, int row, int direction, int length, int from) {
    if ((direction & 2) == 0) {
      int goal = row == goalRow ? goalColumn : column;
      int end = end(alongRows, row, column, direction == EAST, goal);
      if (end >= 0) {
        int straight = Math.abs(end - column) * MoveCost.STRAIGHT;
        reach(end, row, length + straight, from, direction);
      }
    } else {
      int goal = column == goalColumn ? goalRow : row;
      int end = end(alongColumns, column, row, direction == SOUTH, goal);
      if (end >= 0) {
        int straight = Math.abs(end - row) * MoveCost.STRAIGHT;
        reach(column, end, length + straight, from, direction);
      }
    }
  }

  /**
   * The position of the goal or of the jump point to which a straight run leads, -1 for neither.
   *
   * @param goal a position in the line; {@code position} where the goal lies elsewhere
   */
  private static int end(StraightRuns runs, int line, int position, boolean forward, int goal) {
    int end = forward ? runs.forwardEnd(line, position) : runs.backwardEnd(line, position);
    boolean passesGoal = forward ? goal > position && goal <= end : goal < position && goal >= end;
    if (passesGoal) {
      return goal;
    }
    return runs.isFree(line, end) ? end : -1;
  }

  private void reach(int column, int row, int length, int from, int direction) {
    int cell = row * width + column;
    int valid = 2 * generation;
    int known = stamp[cell];
    if (known != valid + 1 && (known != valid || length < g[cell])) {
      g[cell] = length;
      stamp[cell] = valid;
      parent[cell] = from;
      arrival[cell] = (byte) direction;
      open.push(cell, length, MoveCost.octile(column - goalColumn, row - goalRow));
    }
  }

  /** From node to node first the diagonal moves, then the straight ones. */
  private List<Heading> movesTo(int goal) {
    int left = 0;
    for (int cell = goal; g[cell] > 0; cell = parent[cell]) {
      left += Math.max(Math.abs(columnsToParent(cell)), Math.abs(rowsToParent(cell)));
    }
    Heading[] moves = new Heading[left];
    for (int cell = goal; g[cell] > 0; cell = parent[cell]) {
      int dColumn = -columnsToParent(cell);
      int dRow = -rowsToParent(cell);
      int diagonals = Math.min(Math.abs(dColumn), Math.abs(dRow));
      int straights = Math.max(Math.abs(dColumn), Math.abs(dRow)) - diagonals;
      Arrays.fill(moves, left - straights, left, Heading.of(arrival[cell]));
      left -= straights;
      Arrays.fill(moves, left - diagonals, left, Heading.of(diagonal(dColumn, dRow)));
      left -= diagonals;
    }
    return Arrays.asList(moves);
  }

  private int columnsToParent(int cell) {
    return graph.column(parent[cell]) - graph.column(cell);
  }

  private int rowsToParent(int cell) {
    return graph.row(parent[cell]) - graph.row(cell);
  }

  private static int diagonal(int dColumn, int dRow) {
    if (dRow < 0) {
      return dColumn > 0 ? Heading.NORTH_EAST.ordinal() : Heading.NORTH_WEST.ordinal();
    }
    return dColumn > 0 ? Heading.SOUTH_EAST.ordinal() : Heading.SOUTH_WEST.ordinal();
  }

  /**
   * After a diagonal move: on, or to the side by 45 degrees. After a straight one: on; and where
   * the cell beside is free but not the one behind it, to that side and between.
   */
  private static byte[] onward() {
    byte[] onward = new byte[8 * 256];
    for (int arrival = 0; arrival < 8; arrival++) {
      for (int moves = 0; moves < 256; moves++) {
        onward[arrival << 8 | moves] =
            (byte)
                ((arrival & 1) == 1
                    ? bit(arrival - 1) | bit(arrival) | bit(arrival + 1)
                    : bit(arrival) | opened(arrival, moves, 1) | opened(arrival, moves, -1));
      }
    }
    return onward;
  }

  private static int opened(int arrival, int moves, int side) {
    boolean opens =
        (moves & bit(arrival + 2 * side)) != 0 && (moves & bit(arrival + 3 * side)) == 0;
    return opens ? bit(arrival + side) | bit(arrival + 2 * side) : 0;
  }

  private static int bit(int direction) {
    return 1 << (direction & 7);
  }
}
