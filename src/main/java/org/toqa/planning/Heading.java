package org.toqa.planning;

/** The eight directions of a grid, counter-clockwise from east, 45 degrees apart. */
public enum Heading {
  EAST(1, 0),
  NORTH_EAST(1, -1),
  NORTH(0, -1),
  NORTH_WEST(-1, -1),
  WEST(-1, 0),
  SOUTH_WEST(-1, 1),
  SOUTH(0, 1),
  SOUTH_EAST(1, 1);

  private static final Heading[] ALL = values();

  private final int dColumn;
  private final int dRow;

  Heading(int dColumn, int dRow) {
    this.dColumn = dColumn;
    this.dRow = dRow;
  }

  /** Columns that a move in it goes to the east, -1 to 1. */
  public int dColumn() {
    return dColumn;
  }

  /** Rows that a move in it goes to the south, -1 to 1; north is -1. */
  public int dRow() {
    return dRow;
  }

  public boolean isDiagonal() {
    return dColumn != 0 && dRow != 0;
  }

  /** Radians, counter-clockwise from east, in [0, 2 pi). */
  public double angle() {
    return ordinal() * Math.PI / 4;
  }

  /** Turned counter-clockwise by {@code eighths} times 45 degrees. */
  public Heading turned(int eighths) {
    return ALL[Math.floorMod(ordinal() + eighths, ALL.length)];
  }

  /** The heading with that ordinal. */
  static Heading of(int ordinal) {
    return ALL[ordinal];
  }

  /** That of a move by so many columns and rows, each -1 to 1 and not both 0. */
  public static Heading of(int dColumn, int dRow) {
    if (dRow == 0) {
      return dColumn > 0 ? EAST : WEST;
    }
    return ALL[dRow < 0 ? NORTH.ordinal() - dColumn : SOUTH.ordinal() + dColumn];
  }

  /** Eighths of a turn that lead to another heading, counter-clockwise, from -3 to 4. */
  public int eighthsTo(Heading other) {
    return Math.floorMod(other.ordinal() - ordinal() + 3, ALL.length) - 3;
  }

  /**
   * The nearest of the eight to a direction.
   *
   * @param angle radians, counter-clockwise from east, in any range
   */
  public static Heading nearest(double angle) {
    return ALL[Math.floorMod(Math.round(angle / (Math.PI / 4)), ALL.length)];
  }
}
