package org.toqa.allocation;

import java.util.Arrays;

/**
 * The assignment of rows to columns with the least total cost: shortest augmenting paths with dual
 * prices (Jonker and Volgenant, "A shortest augmenting path algorithm for dense and sparse linear
 * assignment problems", Computing 38, 1987; in the rectangular form of Crouse, "On implementing 2D
 * rectangular assignment algorithms", 2016). Rows first bid against each other for their cheapest
 * columns; each of those left over is let in by one search. O(rows^2 columns) at worst, flat
 * arrays.
 *
 * <p>The letters are the papers': u and v are the prices of rows and columns.
 */
public final class Assignment {
  private static final int NONE = -1;
  private static final int PASSES = 2;
  private static final int BIDS_A_ROW = 10;

  private final double[] cost;
  private final int rows;
  private final int columns;
  private final double[] u;
  private final double[] v;
  private final int[] columnOf;
  private final int[] rowOf;

  // the last look at a row: its two cheapest columns and what they cost
  private int cheapest;
  private int runnerUp;
  private double first;
  private double second;

  // one search
  private final double[] shortest;
  private final int[] before;
  private final int[] unvisited;
  private final int[] visitedRows;
  private final int[] visitedColumns;
  private int visited;

  private Assignment(double[] cost, int rows) {
    this.cost = cost;
    this.rows = rows;
    columns = cost.length / rows;
    u = new double[rows];
    v = new double[columns];
    columnOf = new int[rows];
    rowOf = new int[columns];
    shortest = new double[columns];
    before = new int[columns];
    unvisited = new int[columns];
    visitedRows = new int[rows];
    visitedColumns = new int[rows];
    Arrays.fill(columnOf, NONE);
    Arrays.fill(rowOf, NONE);
  }

  /**
   * @param cost finite, row after row; {@code rows * columns} numbers, at least as many columns as
   *     rows
   * @param rows how many, at least 0
   * @return the column of each row, no two the same
   * @throws IllegalArgumentException if so many costs are no such rows
   */
  public static int[] leastCost(double[] cost, int rows) {
    if (rows == 0) {
      return new int[0];
    }
    if (cost.length % rows != 0 || cost.length / rows < rows) {
      throw new IllegalArgumentException(
          cost.length + " costs are not " + rows + " rows of at least as many columns.");
    }
    Assignment assignment = new Assignment(cost, rows);
    if (assignment.columns > 1) {
      assignment.reduceRows();
    }
    assignment.setRowPrices();
    for (int row = 0; row < rows; row++) {
      if (assignment.columnOf[row] == NONE) {
        assignment.insertRow(row);
      }
    }
    return assignment.columnOf;
  }

  /**
   * Augmenting row reduction: each row takes its cheapest column and lowers that one's price by its
   * lead over the second cheapest; who loses it looks again at once. A column that nobody has keeps
   * the price 0, as columns may be left over.
   */
  private void reduceRows() {
    int[] free = new int[rows];
    Arrays.setAll(free, row -> row);
    int count = rows;
    for (int pass = 0; pass < PASSES; pass++) {
      int patience = BIDS_A_ROW * rows; // tiny leads may take turns for long
      int left = 0;
      int next = 0;
      while (next < count) {
        int row = free[next++];
        findCheapest(row);
        double lead = second - first;
        int column = lead > 0 || rowOf[cheapest] == NONE ? cheapest : runnerUp;
        int loser = rowOf[column];
        v[column] -= lead;
        columnOf[row] = column;
        rowOf[column] = row;
        if (loser != NONE) {
          columnOf[loser] = NONE;
          if (lead > 0 && patience-- > 0) {
            free[--next] = loser;
          } else {
            free[left++] = loser;
          }
        }
      }
      count = left;
    }
  }

  private void findCheapest(int row) {
    int begin = row * columns;
    first = Double.POSITIVE_INFINITY;
    second = Double.POSITIVE_INFINITY;
    for (int column = 0; column < columns; column++) {
      double reduced = cost[begin + column] - v[column];
      if (reduced < second) {
        if (reduced < first) {
          second = first;
          runnerUp = cheapest;
          first = reduced;
          cheapest = column;
        } else {
          second = reduced;
          runnerUp = column;
        }
      }
    }
  }

  /** Row prices that fit the columns' ones. */
  private void setRowPrices() {
    for (int row = 0; row < rows; row++) {
      if (columnOf[row] == NONE) {
        findCheapest(row);
        u[row] = first;
      } else {
        u[row] = cost[row * columns + columnOf[row]] - v[columnOf[row]];
      }
    }
  }

  private void insertRow(int row) {
    int sink = search(row);
    double length = shortest[sink];
    u[row] += length;
    for (int k = 1; k < visited; k++) {
      int column = visitedColumns[k];
      u[visitedRows[k]] += length - shortest[column];
      v[column] -= length - shortest[column];
    }
    augment(row, sink);
  }

  /** Dijkstra over reduced costs; answers the nearest column that nobody has. */
  private int search(int start) {
    for (int column = 0; column < columns; column++) {
      unvisited[column] = column;
      shortest[column] = Double.POSITIVE_INFINITY;
    }
    int left = columns;
    visited = 0;
    visitedRows[visited++] = start;
    int row = start;
    double length = 0;
    while (true) {
      int begin = row * columns;
      double offset = length - u[row];
      double least = Double.POSITIVE_INFINITY;
      int nearest = 0;
      for (int k = 0; k < left; k++) {
        int column = unvisited[k];
        double reduced = offset + cost[begin + column] - v[column];
        if (reduced < shortest[column]) {
          shortest[column] = reduced;
          before[column] = row;
        }
        double known = shortest[column];
        if (known < least || (known == least && rowOf[column] == NONE)) {
          least = known;
          nearest = k;
        }
      }
      int column = unvisited[nearest];
      length = least;
      if (rowOf[column] == NONE) {
        return column;
      }
      unvisited[nearest] = unvisited[--left];
      row = rowOf[column];
      visitedColumns[visited] = column;
      visitedRows[visited++] = row;
    }
  }

  private void augment(int start, int sink) {
    int column = sink;
    int row;
    do {
      row = before[column];
      rowOf[column] = row;
      int next = columnOf[row];
      columnOf[row] = column;
      column = next;
    } while (row != start);
  }
}
