package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * A floor in cells that are large enough for a robot each, on which robots are planned together.
 *
 * <p>The side of such a lane cell is a whole number of the floor's cells. A robot in the middle of
 * one touches no other, and one that drives straight to the next touches those two only, so robots
 * that keep to different lane cells never need the same cell of the floor. A lane cell is open
 * where the disc fits in its middle, and joined with the next where the disc fits between them too:
 * a wall in its corner closes nothing. The lattice is laid so that robots on it come near to as
 * much as can be of where they could be without it; a wider one is taken only where it fits the
 * aisles better.
 *
 * <p>Where the floor's own cells are large enough, they are the lane cells. Immutable.
 */
final class LaneGrid {
  /** A lane cell is wider than the robot by at least so much, metres: no robot stops exactly. */
  private static final double SLACK = 0.02;

  /** Lanes that keep off walls are taken where they reach so much of what others do. */
  private static final double AS_MUCH = 0.98;

  /** Cells of the floor that are looked at, to find the best lattice. */
  private static final long MAX_WORK = 20_000_000;

  private final OccupancyGrid floor;

  /** Of the largest robot for which they are, metres. */
  private final double diameter;

  /** Kept from walls where robots pass through lane cells, metres. */
  private final double margin;

  /** The side of a lane cell, in cells of the floor. */
  private final int side;

  /** The floor's cell in the upper left corner of the first lane cell. */
  private final Cell corner;

  /** The lane cells, all open, in the floor's frame. */
  private final OccupancyGrid lattice;

  // what must be free round a lane cell's upper left corner, as columns and rows
  private final List<Cell> disc;
  private final List<Cell> toEast;
  private final List<Cell> toSouth;

  /**
   * @param kept from walls by whole lane cells, metres
   * @param margin kept from walls where robots pass through them, metres
   */
  private LaneGrid(
      OccupancyGrid floor, int side, double diameter, double kept, double margin, Cell corner) {
    this.floor = floor;
    this.margin = margin;
    this.diameter = diameter;
    this.side = side;
    this.corner = corner;
    int columns = (floor.width() - corner.column()) / side;
    int rows = (floor.height() - corner.row()) / side;
    double resolution = floor.resolution();
    Vec2 origin =
        floor
            .origin()
            .plus(
                new Vec2(corner.column(), floor.height() - corner.row() - rows * side)
                    .times(resolution));
    this.lattice =
        new OccupancyGrid(columns, rows, side * resolution, origin, new BitSet())
            .withRules(floor.rules());
    double cells = (diameter + 2 * kept) / resolution;
    this.disc = touched(side, cells, 0, 0);
    this.toEast = touched(side, cells, 1, 0);
    this.toSouth = touched(side, cells, 0, 1);
  }

  /** How many of the floor's cells a lane cell for such a robot has along its side. */
  static int side(OccupancyGrid floor, double diameter) {
    double cells = diameter / floor.resolution();
    return cells <= 1 + 1e-9 ? 1 : (int) Math.ceil((diameter + SLACK) / floor.resolution() - 1e-9);
  }

  /** Whether the floor has room for one such lane cell at all. */
  static boolean hasRoom(OccupancyGrid floor, double diameter) {
    return side(floor, diameter) <= Math.min(floor.width(), floor.height());
  }

  /**
   * @param diameter metres, of the largest robot that shall use them
   * @param margin kept from walls where there is room, metres
   */
  static LaneGrid of(OccupancyGrid floor, double diameter, double margin) {
    if (side(floor, diameter) == 1) {
      return new LaneGrid(floor, 1, diameter, 0, margin, new Cell(0, 0));
    }
    // in an aisle hardly wider than the robot, its middle fits between the middles of two cells
    OccupancyGrid clear = Inflation.inflate(floor, (diameter - floor.resolution()) / 2);
    LaneGrid narrow =
        best(floor, diameter, 0, clear)
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        "The floor is smaller than a robot of that size."));
    return best(floor, diameter, margin, clear)
        .filter(roomy -> roomy.coverage(clear) >= AS_MUCH * narrow.coverage(clear))
        .orElse(narrow);
  }

  /** That with the best coverage. */
  private static Optional<LaneGrid> best(
      OccupancyGrid floor, double diameter, double kept, OccupancyGrid clear) {
    int narrowest = side(floor, diameter + 2 * kept);
    long tries = Math.max(4, MAX_WORK / ((long) floor.width() * floor.height()));
    int sides = Math.max(1, Math.min(narrowest / 2, (int) (tries / 16)));
    int perSide = (int) Math.max(1, Math.sqrt((double) tries / sides));
    LaneGrid best = null;
    int most = -1;
    for (int side = narrowest; side < narrowest + sides; side++) {
      int step = Math.max(1, side / perSide);
      for (int row = 0; row < side && row + side <= floor.height(); row += step) {
        for (int column = 0; column < side && column + side <= floor.width(); column += step) {
          LaneGrid lanes = new LaneGrid(floor, side, diameter, kept, kept, new Cell(column, row));
          int reached = lanes.coverage(clear);
          if (reached > most + (best == null || best.side == side ? 0 : most / 50)) {
            best = lanes;
            most = reached;
          }
        }
      }
    }
    return Optional.ofNullable(best);
  }

  /**
   * How many cells of the floor lie near to open lane cells; those near to the largest connected
   * part count twice.
   *
   * @param clear the cells in which the middle of a robot can be
   */
  private int coverage(OccupancyGrid clear) {
    RoadGraph roads = roads(floor.occupied());
    BitSet near = new BitSet();
    BitSet nearLargest = new BitSet();
    int half = side * 3 / 4;
    for (int v = 0; v < roads.vertexCount(); v++) {
      int column = corner.column() + roads.columnOf(v) * side + side / 2;
      int row = corner.row() + roads.rowOf(v) * side + side / 2;
      int first = Math.max(0, column - half);
      int end = Math.min(floor.width(), column + half + 1);
      for (int r = Math.max(0, row - half); r < Math.min(floor.height(), row + half + 1); r++) {
        near.set(r * floor.width() + first, r * floor.width() + end);
        if (roads.isInLargestPart(v)) {
          nearLargest.set(r * floor.width() + first, r * floor.width() + end);
        }
      }
    }
    near.andNot(clear.occupied());
    nearLargest.andNot(clear.occupied());
    return near.cardinality() + nearLargest.cardinality();
  }

  /**
   * The floor's cells that a disc touches on the path from the middle of a lane cell to the middle
   * of one beside it, counted from the first one's upper left corner.
   */
  private static List<Cell> touched(int side, double diameter, int columns, int rows) {
    OccupancyGrid cells = new OccupancyGrid(2 * side, 2 * side, 1, Vec2.ZERO, new BitSet());
    Vec2 from = new Vec2(side / 2.0, 1.5 * side);
    Vec2 to = from.plus(new Vec2(columns * side, -rows * side));
    return List.copyOf(new Disc(diameter / 2).cellsAlong(cells, from, to));
  }

  /** Whether they are the floor's own cells. */
  boolean isFloorGrid() {
    return side == 1;
  }

  /** The lane cells as a grid; its frame is the floor's. */
  OccupancyGrid lattice() {
    return lattice;
  }

  /**
   * The lane cells that are open, joined where a robot can go from one to the next.
   *
   * @param blocked cells of the floor where robots must not be
   */
  RoadGraph roads(BitSet blocked) {
    BitSet occupied = new BitSet();
    for (int row = 0; row < lattice.height(); row++) {
      for (int column = 0; column < lattice.width(); column++) {
        occupied.set(row * lattice.width() + column, !isClear(column, row, disc, blocked));
      }
    }
    OccupancyGrid open = lattice.withOccupied(occupied);
    if (side == 1) {
      return new RoadGraph(open);
    }
    return new RoadGraph(
        open,
        (column, row, direction) ->
            isClear(column, row, direction == RoadGraph.EAST ? toEast : toSouth, blocked));
  }

  private boolean isClear(int column, int row, List<Cell> touched, BitSet blocked) {
    int firstColumn = corner.column() + column * side;
    int firstRow = corner.row() + row * side;
    for (Cell cell : touched) {
      int index = (firstRow + cell.row()) * floor.width() + firstColumn + cell.column();
      if (blocked.get(index)) {
        return false;
      }
    }
    return true;
  }

  /** The same, where robots also keep off what others have or will need. */
  RoadGraph roads(OccupiedSpace occupied, Collection<Pose> starts) {
    Map<Cell, SweptArea> standing = new HashMap<>();
    starts.forEach(
        start ->
            standing.put(
                lattice.cellAt(start.position()), SweptArea.at(start.position(), diameter / 2)));
    BitSet near = new BitSet();
    for (SweptArea area : occupied.claimed().areas()) {
      area.cells(lattice, diameter / 2 + Clearance.BETWEEN_ROBOTS).addTo(near);
    }
    RoadGraph open = roads(occupied.blocked());
    BitSet closed = new BitSet();
    for (int i = near.nextSetBit(0); i >= 0; i = near.nextSetBit(i + 1)) {
      Cell cell = lattice.cell(i);
      closed.set(i, !standing.containsKey(cell) && !isOff(occupied, standing, cell, cell));
    }
    if (near.isEmpty()) {
      return open;
    }
    closed.or(open.grid().occupied());
    return new RoadGraph(
        lattice.withOccupied(closed),
        (column, row, direction) -> {
          int vertex = open.vertex(column, row);
          int there = open.neighbour(vertex, direction);
          int next = there == RoadGraph.NONE ? open.predecessor(vertex, direction) : there;
          Cell cell = new Cell(column, row);
          if (next == RoadGraph.NONE) {
            return false;
          }
          boolean isNear =
              near.get(lattice.index(cell)) || near.get(lattice.index(open.cell(next)));
          return !isNear || isOff(occupied, standing, cell, open.cell(next));
        });
  }

  /**
   * Whether whoever goes between the middles of two lane cells, one way or the other, keeps off the
   * others; who stands there may be nearer to them already.
   */
  private boolean isOff(OccupiedSpace occupied, Map<Cell, SweptArea> standing, Cell one, Cell two) {
    SweptArea area = SweptArea.along(lattice.centre(one), lattice.centre(two), diameter / 2);
    List<SweptArea> starts =
        Stream.of(standing.get(one), standing.get(two)).filter(Objects::nonNull).toList();
    return starts.isEmpty()
        ? occupied.claimed().isKept(area)
        : starts.stream().allMatch(start -> occupied.claimed().isKept(start, area));
  }

  /**
   * The lane cells, by their index, in whose middle a robot would come too near to one of the
   * areas.
   */
  BitSet cellsNear(List<SweptArea> areas) {
    BitSet near = new BitSet();
    areas.forEach(area -> area.cells(lattice, diameter / 2 + Clearance.BETWEEN_ROBOTS).addTo(near));
    near.stream()
        .filter(i -> areas.stream().allMatch(a -> Clearance.isKept(areaAt(lattice.cell(i)), a)))
        .forEach(near::clear);
    return near;
  }

  /** Where robots pass through the lane cells. */
  LanePoints points(BitSet blocked) {
    return side == 1
        ? LanePoints.of(lattice, blocked, diameter / 2, margin)
        : LanePoints.centres(lattice);
  }

  /** Which lane cells robots cannot take at once, wherever they pass through them. */
  Spacing spacing(RoadGraph roads) {
    return new Spacing(roads, apart());
  }

  /** What is kept between the middles of lane cells that robots take at once, in lane cells. */
  double apart() {
    double apart = diameter + Clearance.BETWEEN_ROBOTS;
    double beside = Math.max(0, apart - lattice.resolution());
    return (apart + (side == 1 ? beside : 0)) / lattice.resolution();
  }

  /** What a robot covers in the middle of a lane cell. */
  SweptArea areaAt(Cell cell) {
    return SweptArea.at(lattice.centre(cell), diameter / 2);
  }

  /** The lane cell round a point, map frame, and those beside it, nearest first. */
  List<Cell> cellsAround(Vec2 point) {
    return lattice.cellsAround(point, 1);
  }
}
