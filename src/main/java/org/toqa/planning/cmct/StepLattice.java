package org.toqa.planning.cmct;

import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;

/**
 * Points over a grid, one length apart along x and another along y, with eight moves between them.
 * Points and rows are counted as cells are: columns to the east, rows to the south.
 *
 * <p>Occupied cells are closed squares, and so is the outside: a point on the border of one is not
 * free. No step is longer than a cell, so nothing that is occupied lies between two points without
 * holding one of them; a diagonal move needs both points beside it, as on a grid. Which points are
 * free is looked up when it is asked, exactly, in whole numbers.
 *
 * <p>Immutable; any thread may ask.
 */
public final class StepLattice {
  private static final Heading[] HEADINGS = Heading.values();

  /** The published number of steps from start to goal along each axis. */
  private static final int STEPS = 10;

  private final OccupancyGrid grid;
  private final Axis columns;
  private final Axis rows;

  /** Whether the points are the middles of the cells. */
  private final boolean isOfCells;

  /**
   * One direction of a lattice. Lengths in it are whole numbers of {@code 1 / unit} cell.
   *
   * @param unit so many are a cell
   * @param step between two points
   * @param first where the first point is, from the grid's western or northern border
   * @param size points
   */
  private record Axis(int unit, int step, int first, int size) {

    /**
     * That of all points strictly inside a grid.
     *
     * @param cell a point is in its middle
     * @param cells of the grid
     * @param stepsOfCell a step is this many cells ...
     * @param parts ... divided by so many
     */
    static Axis of(int cell, int cells, int stepsOfCell, int parts) {
      int unit = 2 * parts;
      int step = 2 * stepsOfCell;
      int base = cell * unit + parts;
      int before = (base - 1) / step;
      int after = (cells * unit - base - 1) / step;
      return new Axis(unit, step, base - before * step, before + 1 + after);
    }

    int at(int index) {
      return first + index * step;
    }

    /** The point in the middle of a cell. */
    int index(int cell) {
      return (cell * unit + unit / 2 - first) / step;
    }

    double cells(int index) {
      return (double) at(index) / unit;
    }
  }

  private StepLattice(OccupancyGrid grid, Axis columns, Axis rows, boolean isOfCells) {
    this.grid = grid;
    this.columns = columns;
    this.rows = rows;
    this.isOfCells = isOfCells;
  }

  /** The middles of a grid's cells, with the grid's own rules of moving. */
  public static StepLattice ofCells(OccupancyGrid grid) {
    return new StepLattice(
        grid, Axis.of(0, grid.width(), 1, 1), Axis.of(0, grid.height(), 1, 1), true);
  }

  /**
   * The published one: a step is a tenth of the way from start to goal along each axis, so that ten
   * diagonal moves are the straight line. On ways of more than ten cells there are more steps, each
   * at most a cell long; and where start and goal agree in one coordinate, the step along it is as
   * long as the other, without which nothing could be gone round.
   *
   * @param start the start is its middle; inside the grid
   * @param goal the goal is its middle; inside the grid, another cell
   * @throws IllegalArgumentException a cell is not inside the grid, both are the same, or the grid
   *     has rules of direction, which are for moves from cell to cell
   */
  public static StepLattice ofTenths(OccupancyGrid grid, Cell start, Cell goal) {
    if (!grid.contains(start) || !grid.contains(goal) || start.equals(goal)) {
      throw new IllegalArgumentException(
          "There is no way from %s to %s to take a tenth of.".formatted(start, goal));
    }
    if (grid.rules().isDirected()) {
      throw new IllegalArgumentException("Directions are for moves from cell to cell.");
    }
    int dColumns = Math.abs(goal.column() - start.column());
    int dRows = Math.abs(goal.row() - start.row());
    // C_x = |X_s - X_f| / 10, C_y = |Y_s - Y_f| / 10   (CMCT-PP, step 2)
    int parts = Math.max(STEPS, Math.max(dColumns, dRows));
    return new StepLattice(
        grid,
        Axis.of(start.column(), grid.width(), dColumns == 0 ? dRows : dColumns, parts),
        Axis.of(start.row(), grid.height(), dRows == 0 ? dColumns : dRows, parts),
        false);
  }

  /** Points from west to east. */
  public int width() {
    return columns.size();
  }

  /** Points from north to south. */
  public int height() {
    return rows.size();
  }

  /** Metres from a point to the next one in the east. */
  public double stepX() {
    return grid.resolution() * columns.step() / columns.unit();
  }

  /** Metres from a point to the next one in the north. */
  public double stepY() {
    return grid.resolution() * rows.step() / rows.unit();
  }

  /**
   * The point in the middle of a cell of which the lattice was made, or of any if it is of cells.
   */
  public Cell pointOf(Cell cell) {
    return new Cell(columns.index(cell.column()), rows.index(cell.row()));
  }

  /** Where a point is, metres, map frame. */
  public Vec2 position(Cell point) {
    double south = rows.cells(point.row());
    return grid.origin()
        .plus(
            new Vec2(columns.cells(point.column()), grid.height() - south)
                .times(grid.resolution()));
  }

  /** Metres of the way through points. */
  public double length(List<Cell> points) {
    return Vec2.lengthOf(points.stream().map(this::position).toList());
  }

  /** Metres of a move. */
  double length(Heading heading) {
    return Math.hypot(heading.dColumn() * stepX(), heading.dRow() * stepY());
  }

  /** Whether a point is free; outside of the lattice none is. */
  public boolean isFree(int column, int row) {
    return column >= 0
        && column < columns.size()
        && row >= 0
        && row < rows.size()
        && isFreeAt(columns.at(column), rows.at(row));
  }

  private boolean isFreeAt(int east, int south) {
    int column = east / columns.unit();
    int row = south / rows.unit();
    int west = east % columns.unit() == 0 ? column - 1 : column;
    int north = south % rows.unit() == 0 ? row - 1 : row;
    return grid.isFree(column, row)
        && grid.isFree(west, row)
        && grid.isFree(column, north)
        && grid.isFree(west, north);
  }

  /** Whether a move from a free point is allowed. */
  boolean allows(int column, int row, Heading heading) {
    int toColumn = column + heading.dColumn();
    int toRow = row + heading.dRow();
    if (!isFree(toColumn, toRow)
        || (heading.isDiagonal() && !(isFree(toColumn, row) && isFree(column, toRow)))) {
      return false;
    }
    return !isOfCells
        || (grid.forbiddenFrom(row * grid.width() + column) >> heading.ordinal() & 1) == 0;
  }

  /** Whether what the grid's rules forbid is forbidden in one direction only. */
  boolean isDirected() {
    return isOfCells && grid.rules().isDirected();
  }

  /**
   * The square of the distance of two points, in a whole unit of its own: it says which is nearer.
   */
  long squareBetween(int column, int row, Cell other) {
    long east = (long) columns.step() * (column - other.column());
    long south = (long) rows.step() * (row - other.row());
    return east * east + south * south;
  }

  static Heading[] headings() {
    return HEADINGS;
  }
}
