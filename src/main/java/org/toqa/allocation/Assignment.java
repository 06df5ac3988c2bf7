package org.toqa.allocation;

import java.util.Arrays;

/**
 * The assignment of rows to columns with the least total cost: shortest augmenting paths with dual
 * prices (Jonker and Volgenant, "A shortest augmenting path algorithm for dense and sparse linear
 * assignment problems", Computing 38, 1987; in the rectangular form of Crouse, "On implementing 2D
 * rectangular assignment algorithms", 2016). Rows take their cheapest columns where nobody else
 * does; each of the others is let in by one search. O(rows^2 columns) at worst, flat arrays.
 *
 * <p>The letters are the papers': u and v are the prices of rows and columns.
 */
public final class Assignment {
  private static final int NONE = -1;

  private final double[] cost;
  private final int rows;
  private final int columns;
  private final double[] u;
  private final double[] v;
  private final int[] columnOf;
  private final int[] rowOf;

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
   * @return the column of each row, no two the same
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
    assignment.takeCheapest();
    for (int row = 0; row < rows; row++) {
      if (assignment.columnOf[row] == NONE) {
        assignment.letIn(row);
      }
    }
    return assignment.columnOf;
  }

  /** Row prices from the rows' least costs; who is first takes a column at that price. */
  private void takeCheapest() {
    for (int row = 0; row < rows; row++) {
      int begin = row * columns;
      int cheapest = 0;
      for (int column = 1; column < columns; column++) {
        if (cost[begin + column] < cost[begin + cheapest]) {
          cheapest = column;
        }
      }
      u[row] = cost[begin + cheapest];
      if (rowOf[cheapest] == NONE) {
        rowOf[cheapest] = row;
        columnOf[row] = cheapest;
      }
    }
  }

  private void letIn(int row) {
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
