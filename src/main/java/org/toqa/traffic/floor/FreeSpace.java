package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.BySize;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.Inflation;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.traffic.RoadGraph;

/** What blocks cells of the floor, walls and obstacles, and where robots of a size fit. */
final class FreeSpace {
  /** Metres that a robot still keeps from walls where there is no room for its margin. */
  private static final double NARROW = 0.02;

  /** Metres. */
  private static final double MARGIN_STEP = 0.01;

  private static final double ROUNDING = 1e-6;

  private final OccupancyGrid grid;
  private final Margins margins;
  private final BitSet walls;
  private Obstacles obstacles = Obstacles.NONE;
  private BitSet blocked;

  private final BySize<OccupancyGrid> freeOfWalls;
  private final BySize<OccupancyGrid> freeCells = new BySize<>();
  private final BySize<List<Cell>> discOffsets = new BySize<>();
  private final BySize<LaneGrid> laneGrid = new BySize<>();
  private final BySize<RoadGraph> laneRoads = new BySize<>();

  /** The floor as it is for some robots, by the cells of obstacles that count for these. */
  private final Map<BitSet, FreeSpace> others = new HashMap<>();

  FreeSpace(OccupancyGrid grid, Margins margins) {
    this(grid, margins, new BySize<>());
  }

  private FreeSpace(OccupancyGrid grid, Margins margins, BySize<OccupancyGrid> freeOfWalls) {
    this.grid = grid;
    this.margins = margins;
    this.freeOfWalls = freeOfWalls;
    this.walls = grid.occupied();
    this.blocked = walls;
  }

  OccupancyGrid grid() {
    return grid;
  }

  Margins margins() {
    return margins;
  }

  /** What a robot alone keeps from walls, metres, the best first. */
  List<Double> wallSteps() {
    double kept = margins.robot();
    return kept > NARROW ? List.of(kept, NARROW) : List.of(kept);
  }

  void setObstacles(Obstacles now) {
    boolean isChanged = !now.cells().equals(obstacles.cells());
    obstacles = now;
    if (isChanged) {
      blocked = (BitSet) walls.clone();
      blocked.or(now.cells());
      freeCells.clear();
      laneRoads.clear();
      others.clear();
    }
  }

  /** The floor as it is for a robot, for which some obstacles may be none. */
  FreeSpace seenBy(TrafficRobot robot) {
    return obstacles.allCountFor(robot.name)
        ? this
        : others.computeIfAbsent(obstacles.of(robot.name), this::withObstacles);
  }

  private FreeSpace withObstacles(BitSet cells) {
    FreeSpace space = new FreeSpace(grid, margins, freeOfWalls);
    space.setObstacles(new Obstacles(cells, Map.of()));
    return space;
  }

  BitSet obstacles() {
    return obstacles.cells();
  }

  /** Walls and obstacles; not to be changed. */
  BitSet blocked() {
    return blocked;
  }

  /** Where the middle of a robot can be, on a floor without obstacles. */
  OccupancyGrid freeOfWalls(double radius) {
    return freeOfWalls.get(radius, r -> Inflation.inflate(grid, r));
  }

  /** Where the middle of a robot can be. */
  OccupancyGrid freeCells(double radius) {
    return freeCells.get(
        radius,
        r -> {
          OccupancyGrid free = freeOfWalls(r);
          return obstacles().isEmpty() ? free : alsoBlocked(free, inflated(obstacles(), r));
        });
  }

  /**
   * The same where other robots' areas are closed, as far as a robot that sets out keeps off them.
   *
   * @param room kept from walls and obstacles, metres
   * @param standing what the robot covers where it sets out
   * @param here the cell where it is, which never counts as closed
   */
  OccupancyGrid freeCells(
      double radius, double room, List<SweptArea> claimed, SweptArea standing, Cell here) {
    OccupancyGrid free = freeCells(radius + room);
    if (claimed.isEmpty() && free.isFree(here)) {
      return free;
    }
    BitSet more = free.occupied();
    for (SweptArea area : claimed) {
      double apart = radius + Clearance.needed(standing, area) - ROUNDING;
      area.middlesWithin(grid, apart).addTo(more);
    }
    if (grid.contains(here)) { // a robot may say that it is beside the map
      more.clear(grid.index(here));
    }
    return grid.withOccupied(more);
  }

  private OccupancyGrid alsoBlocked(OccupancyGrid free, BitSet more) {
    more.or(free.occupied());
    return grid.withOccupied(more);
  }

  /** The cells on whose middle a disc would touch one of these. */
  private BitSet inflated(BitSet cells, double radius) {
    List<Cell> reach = discOffsets.get(radius, this::touchedOffsets);
    BitSet grown = new BitSet();
    for (int i = cells.nextSetBit(0); i >= 0; i = cells.nextSetBit(i + 1)) {
      int column = i % grid.width();
      int row = i / grid.width();
      for (Cell by : reach) {
        if (grid.contains(column + by.column(), row + by.row())) {
          grown.set(i + by.row() * grid.width() + by.column());
        }
      }
    }
    return grown;
  }

  /** The cells round one whose middle is the disc's that the disc touches, as columns and rows. */
  private List<Cell> touchedOffsets(double radius) {
    int side = 2 * (int) Math.ceil(radius / grid.resolution()) + 1;
    OccupancyGrid cells = new OccupancyGrid(side, side, grid.resolution(), Vec2.ZERO, new BitSet());
    Cell middle = new Cell(side / 2, side / 2);
    List<Cell> reach = new ArrayList<>();
    for (Cell cell : new Disc(radius).cellsAt(cells, cells.centre(middle))) {
      reach.add(new Cell(cell.column() - middle.column(), cell.row() - middle.row()));
    }
    return List.copyOf(reach);
  }

  /**
   * Whether a robot that drives sections from where it stops next keeps so far from walls and
   * obstacles, metres; to those to which it has hardly any room where it begins, or at its goal, it
   * comes no nearer than there.
   */
  boolean hasRoom(TrafficRobot robot, List<Section> sections, double room) {
    Pose start = robot.committedEnd();
    double kept = robot.radius() + room;
    double gap = kept;
    BitSet near = new BitSet();
    Pose end = sections.getLast().end();
    for (Pose tight : robot.isGoal(end) ? List.of(start, end) : List.of(start)) {
      BitSet touched = new BitSet();
      SweptArea.at(tight.position(), robot.radius() + NARROW).cells(grid, 0).addTo(touched);
      touched.and(blocked);
      gap = Math.min(gap, distance(tight.position(), touched));
      near.or(touched);
    }
    if (near.isEmpty()) {
      return isClearOf(start, sections, kept, blocked);
    }
    BitSet others = (BitSet) blocked.clone();
    others.andNot(near);
    return isClearOf(start, sections, kept, others)
        && isClearOf(start, sections, Math.max(gap - ROUNDING, ROUNDING), near);
  }

  /** Metres to the nearest of some cells; without end where there is none. */
  double distance(Vec2 point, BitSet cells) {
    return cells.stream()
        .mapToDouble(cell -> Disc.distanceToCell(grid, point, grid.cell(cell)))
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }

  /**
   * Whether a robot that drives straight keeps its margin from walls and obstacles, or comes no
   * nearer to any than it is where it begins or ends.
   */
  boolean keepsMargin(Vec2 from, Vec2 to, double radius) {
    double atEnds = Math.min(keptMargin(from, from, radius), keptMargin(to, to, radius));
    return keptMargin(from, to, radius) >= atEnds;
  }

  /** The same of the little that a robot keeps where there is no room for its margin. */
  boolean isWideEnough(Vec2 from, Vec2 to, double radius) {
    double atEnd = keptMargin(to, to, radius);
    return keptMargin(from, to, radius) >= Math.min(NARROW, atEnd) - ROUNDING;
  }

  /** What it keeps of its margin, metres, in whole steps; negative: it has no room. */
  double keptMargin(Vec2 from, Vec2 to, double radius) {
    for (int steps = (int) Math.round(margins.robot() / MARGIN_STEP); steps >= 0; steps--) {
      double kept = steps * MARGIN_STEP;
      if (isClear(SweptArea.along(from, to, radius + kept))) {
        return kept;
      }
    }
    return -1;
  }

  private boolean isClear(SweptArea area) {
    return !area.cells(grid, 0).intersects(blocked);
  }

  /** Whether a disc of some radius on that path, which begins at a pose, touches no such cell. */
  boolean isClearOf(Pose start, List<Section> sections, double radius, BitSet cells) {
    Pose pose = start;
    for (Section section : sections) {
      for (Segment segment : section.segments()) {
        if (SweptArea.along(pose, segment, radius).cells(grid, 0).intersects(cells)) {
          return false;
        }
        pose = pose.advanced(segment.twist(), segment.t());
      }
    }
    return true;
  }

  /** Where robots pass through the floor's cells. */
  LanePoints points(double radius) {
    return LanePoints.of(grid, blocked, radius, margins.robot());
  }

  /** The floor in cells that are large enough for robots of that size. */
  LaneGrid laneGrid(double diameter) {
    return laneGrid.get(diameter, d -> LaneGrid.of(grid, d, margins.robot()));
  }

  /**
   * Its lane cells, open where neither walls nor obstacles are; the same object until these change.
   */
  RoadGraph laneRoads(double diameter) {
    return laneRoads.get(diameter, d -> laneGrid(d).roads(blocked));
  }
}
