package org.toqa.grid;

/**
 * A cell of a grid.
 *
 * @param column from 0, to the east
 * @param row from 0 at the top of the picture, to the south
 */
public record Cell(int column, int row) {

  @Override
  public String toString() {
    return "(" + column + "," + row + ")";
  }
}
