package org.toqa.planning;

import java.util.Arrays;

/**
 * A* over jump points, as {@link JumpPointSearch} describes it. Flat arrays by cell, 12 B each; a
 * generation stamp makes them new without clearing. Confined to one thread.
 */
final class JumpPoints {
  private static final int ALL_DIRECTIONS = 0xFF;
  private static final int EAST = Heading.EAST.ordinal();
  private static final int SOUTH = Heading.SOUTH.ordinal();
  private static final int STEPS_A_CHECK = 4096;

  /** Directions in which a shortest path may go on, by {@code 256 arrival + moves}. */
  private static final byte[] ONWARD = onward();

  private GridLayout layout;
  private MoveGraph graph;
  private int[] g = {};

  /** {@code 2 generation}: the cell's values are valid; {@code 2 generation + 1}: and final. */
  private int[] stamp = {};

  /** {@code 8 parent + direction of the last move}. */
  private int[] arrival = {};

  private final OpenList open = new OpenList();
  private int generation;
  private int goalColumn;
  private int goalRow;
  private long expandedCount;
  private int stepsToCheck = STEPS_A_CHECK;

  /** The cells of the last path's jump points, the goal first, the start last. */
  private int[] points = new int[64];

  private int pointCount;

  JumpPoints(GridLayout layout) {
    this.layout = layout;
    graph = layout.graph();
  }

  /**
   * Finds a shortest path from jump point to jump point.
   *
   * @param goal not the start
   * @return whether there is one
   */
  boolean search(GridLayout gridLayout, int start, int goal) {
    begin(gridLayout, goal);
    reach(graph.column(start), graph.row(start), 0, start, EAST);
    while (!open.isEmpty()) {
      int cell = open.pop();
      if (stamp[cell] != 2 * generation + 1) {
        stamp[cell] = 2 * generation + 1;
        if (cell == goal) {
          findPoints(start, goal);
          return true;
        }
        expand(cell, cell == start ? ALL_DIRECTIONS : onward(cell));
      }
    }
    return false;
  }

  private void begin(GridLayout gridLayout, int goal) {
    layout = gridLayout;
    graph = gridLayout.graph();
    if (stamp.length < graph.size()) {
      g = new int[graph.size()];
      stamp = new int[graph.size()];
      arrival = new int[graph.size()];
      generation = 0;
    }
    if (generation == Integer.MAX_VALUE / 2 - 1) {
      generation = 0;
      Arrays.fill(stamp, 0);
    }
    generation++;
    goalColumn = graph.column(goal);
    goalRow = graph.row(goal);
    open.clear();
  }

  private void findPoints(int start, int goal) {
    pointCount = 0;
    for (int cell = goal; ; cell = arrival[cell] >> 3) {
      if (pointCount == points.length) {
        points = Arrays.copyOf(points, 2 * pointCount);
      }
      points[pointCount++] = cell;
      if (cell == start) {
        return;
      }
    }
  }

  /** The length of the path that was found last. */
  int length() {
    return g[points[0]];
  }

  /** How many pieces lie between the jump points of that path, its start and its goal. */
  int pieceCount() {
    return pointCount - 1;
  }

  /** The jump point where a piece begins; they count from the start on. */
  int pieceStart(int piece) {
    return points[pointCount - 1 - piece];
  }

  /** The cell where it ends: first diagonal moves lead there, if any, then straight ones. */
  int pieceEnd(int piece) {
    return points[pointCount - 2 - piece];
  }

  /** That path's moves. */
  void findMoves(MoveSequence moves) {
    moves.clear();
    for (int i = 0; i < pieceCount(); i++) {
      int columns = graph.column(pieceEnd(i)) - graph.column(pieceStart(i));
      int rows = graph.row(pieceEnd(i)) - graph.row(pieceStart(i));
      int diagonals = Math.min(Math.abs(columns), Math.abs(rows));
      int straights = Math.max(Math.abs(columns), Math.abs(rows)) - diagonals;
      moves.add(Heading.of(Integer.signum(columns), Integer.signum(rows)).ordinal(), diagonals);
      moves.add(arrival[pieceEnd(i)] & 7, straights);
    }
  }

  private int onward(int cell) {
    return ONWARD[(arrival[cell] & 7) << 8 | graph.moves(cell)];
  }

  private void expand(int cell, int directions) {
    expandedCount++;
    checkLimit(1);
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

  private void checkLimit(int steps) {
    stepsToCheck -= steps;
    if (stepsToCheck <= 0) {
      stepsToCheck = STEPS_A_CHECK;
      SearchLimit.check();
    }
  }

  /** How many jump points were ever expanded. */
  long expandedCount() {
    return expandedCount;
  }

  /** Looks to both sides of every cell of a diagonal. */
  private void runDiagonally(int from, int direction) {
    Heading heading = Heading.of(direction);
    int column = graph.column(from);
    int row = graph.row(from);
    int length = g[from];
    int cell = from;
    while (graph.allows(cell, direction)) {
      checkLimit(1);
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
      int end = end(layout.alongRows(), row, column, direction == EAST, goal);
      if (end >= 0) {
        int straight = Math.abs(end - column) * MoveCost.STRAIGHT;
        reach(end, row, length + straight, from, direction);
      }
    } else {
      int goal = column == goalColumn ? goalRow : row;
      int end = end(layout.alongColumns(), column, row, direction == SOUTH, goal);
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
    int cell = row * graph.width() + column;
    int valid = 2 * generation;
    int known = stamp[cell];
    if (known != valid + 1 && (known != valid || length < g[cell])) {
      g[cell] = length;
      stamp[cell] = valid;
      arrival[cell] = from << 3 | direction;
      open.push(cell, length, MoveCost.octile(column - goalColumn, row - goalRow));
    }
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
