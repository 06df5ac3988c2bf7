package org.toqa.grid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * Which cells of a floor are free. Row 0 is the top of the picture, as in ROS and MovingAI; the map
 * frame has x to the east and y to the north, with {@code origin} at the lower left corner of the
 * lower left cell. Columns count from 0 to the east, rows from 0 to the south. With it goes how
 * robots may move over the free cells ({@link MoveRules}). Immutable.
 */
public final class OccupancyGrid {
  private final int width;
  private final int height;
  private final double resolution;
  private final Vec2 origin;
  private final BitSet occupied;
  private final MoveRules rules;
  private final ForbiddenMoves forbiddenMoves;

  /**
   * @param width cells from west to east, at least 1
   * @param height cells from north to south, at least 1
   * @param resolution metres along a cell's side, above 0
   * @param origin metres, the lower left corner of the grid in the map frame
   * @param occupied bit {@code row * width + column} set where the cell is not free
   * @throws IllegalArgumentException if a size is out of range
   */
  public OccupancyGrid(int width, int height, double resolution, Vec2 origin, BitSet occupied) {
    this(width, height, resolution, origin, occupied, MoveRules.NONE, ForbiddenMoves.NONE);
  }

  private OccupancyGrid(
      int width,
      int height,
      double resolution,
      Vec2 origin,
      BitSet occupied,
      MoveRules rules,
      ForbiddenMoves forbiddenMoves) {
    if (width < 1 || height < 1 || !(resolution > 0)) {
      throw new IllegalArgumentException(
          "A grid has at least one cell of positive size, not "
              + width
              + " x "
              + height
              + " cells of "
              + resolution
              + " m.");
    }
    this.width = width;
    this.height = height;
    this.resolution = resolution;
    this.origin = origin;
    this.occupied = (BitSet) occupied.clone();
    this.rules = rules;
    this.forbiddenMoves = forbiddenMoves;
  }

  /**
   * A grid of 1 m cells at the origin, drawn in text: '.' is free, anything else is not.
   *
   * @throws IllegalArgumentException if the rows are not equally wide
   */
  public static OccupancyGrid parse(String... rows) {
    int width = rows[0].length();
    BitSet occupied = new BitSet();
    for (int row = 0; row < rows.length; row++) {
      if (rows[row].length() != width) {
        throw new IllegalArgumentException("Row " + row + " is not " + width + " cells wide.");
      }
      for (int column = 0; column < width; column++) {
        occupied.set(row * width + column, rows[row].charAt(column) != '.');
      }
    }
    return new OccupancyGrid(width, rows.length, 1, Vec2.ZERO, occupied);
  }

  /** Cells from west to east. */
  public int width() {
    return width;
  }

  /** Cells from north to south. */
  public int height() {
    return height;
  }

  /** Metres along a cell's side. */
  public double resolution() {
    return resolution;
  }

  /** The grid's lower left corner in the map frame, metres. */
  public Vec2 origin() {
    return origin;
  }

  /** Whether there is such a cell. */
  public boolean contains(int column, int row) {
    return column >= 0 && column < width && row >= 0 && row < height;
  }

  public boolean contains(Cell cell) {
    return contains(cell.column(), cell.row());
  }

  /** False outside the grid. */
  public boolean isFree(int column, int row) {
    return contains(column, row) && !occupied.get(row * width + column);
  }

  public boolean isFree(Cell cell) {
    return isFree(cell.column(), cell.row());
  }

  /** {@code row * width + column}: the cell's place in flat arrays. */
  public int index(Cell cell) {
    return cell.row() * width + cell.column();
  }

  /** The cell of an {@link #index}. */
  public Cell cell(int index) {
    return new Cell(index % width, index / width);
  }

  /** A copy of the occupied bits, by {@link #index}. */
  public BitSet occupied() {
    return (BitSet) occupied.clone();
  }

  /** The cells that are free in one and occupied in the other, by {@link #index}; of equal size. */
  public BitSet differences(OccupancyGrid other) {
    BitSet cells = occupied();
    cells.xor(other.occupied);
    return cells;
  }

  /** The same frame and rules with other cells occupied. */
  public OccupancyGrid withOccupied(BitSet others) {
    return new OccupancyGrid(width, height, resolution, origin, others, rules, forbiddenMoves);
  }

  /** The same cells under other rules. */
  public OccupancyGrid withRules(MoveRules others) {
    return others.equals(rules)
        ? this
        : new OccupancyGrid(
            width, height, resolution, origin, occupied, others, ForbiddenMoves.of(this, others));
  }

  /** How robots may move over its free cells. */
  public MoveRules rules() {
    return rules;
  }

  /**
   * The moves to the eight cells beside one that the rules forbid, as bits by direction,
   * counter-clockwise from east in steps of 45 degrees.
   *
   * @param cell by {@link #index}
   */
  public int forbiddenFrom(int cell) {
    return forbiddenMoves.from(cell);
  }

  /** The same of the moves to a cell, by the direction in which they come from beside it. */
  public int forbiddenInto(int cell) {
    return forbiddenMoves.into(cell);
  }

  /** The middle of a cell, metres, map frame; the cell may lie outside the grid. */
  public Vec2 centre(Cell cell) {
    // centre = origin + ((c + 1/2) k, (H - 1 - r + 1/2) k)   (Tanta, "Map and planner")
    return new Vec2(
        origin.x() + (cell.column() + 0.5) * resolution,
        origin.y() + (height - 1 - cell.row() + 0.5) * resolution);
  }

  /** The cell that holds the point, metres, map frame; it may lie outside the grid. */
  public Cell cellAt(Vec2 point) {
    int column = (int) Math.floor((point.x() - origin.x()) / resolution);
    int up = (int) Math.floor((point.y() - origin.y()) / resolution);
    return new Cell(column, height - 1 - up);
  }

  /**
   * The cells of the grid in a square round the cell of a point, those first whose middle is
   * nearest to the point; of equally near ones the northern and then the western first.
   *
   * @param point metres, map frame
   * @param reach cells on each side of that in the middle
   */
  public List<Cell> cellsAround(Vec2 point, int reach) {
    Cell middle = cellAt(point);
    List<Cell> cells = new ArrayList<>();
    for (int row = middle.row() - reach; row <= middle.row() + reach; row++) {
      for (int column = middle.column() - reach; column <= middle.column() + reach; column++) {
        if (contains(column, row)) {
          cells.add(new Cell(column, row));
        }
      }
    }
    cells.sort(Comparator.comparingDouble(cell -> centre(cell).distanceTo(point)));
    return cells;
  }

  /** Whether the point, metres, map frame, lies on a free cell. */
  public boolean isFree(Vec2 point) {
    return isFree(cellAt(point));
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof OccupancyGrid that
        && width == that.width
        && height == that.height
        && resolution == that.resolution
        && origin.equals(that.origin)
        && rules.equals(that.rules)
        && occupied.equals(that.occupied);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(new int[] {width, height, occupied.hashCode()});
  }
}
