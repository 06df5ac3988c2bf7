package org.toqa.traffic.floor;

import static java.util.Comparator.comparingDouble;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.planning.HeadingAStar;
import org.toqa.planning.Path;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanResult;
import org.toqa.traffic.RoadGraph;

/**
 * A robot's own shortest way in eight headings, smooth, as if it were alone or round the others.
 */
final class OwnWays {
  /** So many cells beside the robot and its goal its way over cells may begin and end. */
  private static final int BESIDE = 2;

  /** So many lane cells from its goal a robot may go straight there, in any heading. */
  private static final int NEAR = 3;

  private static final double ROUNDING = 1e-4;

  private final Ground ground;
  private final CourseFitter fitter;
  private final GroupWays groups;
  private final PathPlanner alone = new HeadingAStar();
  private final PathPlanner amongOthers = new HeadingAStar();

  OwnWays(Ground ground, CourseFitter fitter) {
    this.ground = ground;
    this.fitter = fitter;
    this.groups = new GroupWays(ground.grid(), fitter);
  }

  /** As if no other robot were there; empty where the floor has no way. */
  Optional<List<Stretch>> alone(Mover m) {
    Cell goal = m.goalCell();
    if (goal == null) {
      return Optional.empty();
    }
    Group group = m.group();
    if (group != null) {
      return together(m, group, ground.closed());
    }
    OccupancyGrid free = ground.clear(m.radius, new BitSet(), List.of(), m.releasedCell());
    return fitted(alone, free, m, goal, way -> true);
  }

  /** As if all other robots made room that can. */
  Optional<List<Stretch>> roundFixed(Mover m, Collection<Mover> movers) {
    BitSet fixed = new BitSet();
    movers.stream().filter(o -> o != m && !o.movable).forEach(o -> o.addClaimedTo(fixed));
    return fixed.isEmpty() ? alone(m) : among(m, movers, fixed);
  }

  /** The points of its way, were there neither robots nor obstacles; empty where there is none. */
  List<Vec2> withoutObstacles(Mover m) {
    Cell goal = m.goalCell();
    OccupancyGrid grid = ground.grid();
    OccupancyGrid free = ground.clearOfWalls(m.radius);
    return goal == null
        ? List.of()
        : path(alone, free, entry(free, m), goal).stream()
            .flatMap(path -> path.cells().stream())
            .map(grid::centre)
            .toList();
  }

  /**
   * One that meets nobody's cells.
   *
   * @param claimed the cells that others have or will need
   */
  Optional<List<Stretch>> among(Mover m, Collection<Mover> others, BitSet claimed) {
    Cell goal = m.goalCell();
    Group group = m.group();
    if (goal == null) {
      return Optional.empty();
    }
    if (group != null) {
      BitSet closed = (BitSet) ground.closed().clone();
      closed.or(claimed);
      return together(m, group, closed);
    }
    return among(m, others, claimed, (free, start) -> goal);
  }

  /** What it touches already it may leave. */
  private Optional<List<Stretch>> together(Mover m, Group group, BitSet cells) {
    BitSet closed = (BitSet) cells.clone();
    m.standingAt(m.releasedEnd()).forEach(closed::clear);
    Vec2 goal = m.goal;
    return goal == null ? Optional.empty() : groups.way(m, group, goal, closed);
  }

  /**
   * One that meets nobody's cells, to the nearest place outside of some cells.
   *
   * @param left what it has to leave
   */
  Optional<List<Stretch>> outOf(Mover m, Collection<Mover> others, BitSet claimed, BitSet left) {
    return m.group() != null
        ? Optional.empty()
        : among(m, others, claimed, (free, start) -> nearestOutside(free, start, m.radius, left));
  }

  /** Where to go on a floor, if anywhere. */
  private interface Aim {
    @Nullable Cell from(OccupancyGrid free, Cell start);
  }

  private @Nullable Cell nearestOutside(
      OccupancyGrid free, Cell start, double radius, BitSet left) {
    RoadGraph roads = new RoadGraph(free);
    BitSet seen = new BitSet();
    Deque<Integer> queue = new ArrayDeque<>();
    queue.add(roads.vertex(start));
    while (!queue.isEmpty()) {
      int vertex = queue.poll();
      Cell cell = roads.cell(vertex);
      if (!SweptCells.standing(free, free.centre(cell), radius).intersects(left)) {
        return cell;
      }
      for (int d = 0; d < RoadGraph.DIRECTIONS; d++) {
        int next = roads.neighbour(vertex, d);
        if (next != RoadGraph.NONE && !seen.get(next)) {
          seen.set(next);
          queue.add(next);
        }
      }
    }
    return null;
  }

  private Optional<List<Stretch>> among(
      Mover m, Collection<Mover> others, BitSet claimed, Aim aim) {
    List<Mover> beside = beside(m, others);
    BitSet taken = claimed;
    if (!beside.isEmpty()) {
      taken = (BitSet) claimed.clone();
      m.standing().forEach(taken::clear);
    }
    BitSet notOwn = taken;
    List<Round> discs = beside.stream().flatMap(o -> o.discs().stream()).toList();
    OccupancyGrid free = ground.clear(m.radius, notOwn, discs, m.releasedCell());
    Cell goal = aim.from(free, entry(free, m));
    if (goal == null) {
      return Optional.empty();
    }
    return fitted(amongOthers, free, m, goal, way -> meetsNobody(m, way, beside, notOwn));
  }

  /** Clear of walls and obstacles; straight to a goal that is near, else over cells. */
  private Optional<List<Stretch>> fitted(
      PathPlanner planner,
      OccupancyGrid free,
      Mover m,
      Cell goal,
      Predicate<List<Stretch>> isRight) {
    Predicate<List<Stretch>> isClearAndRight = way -> isClear(m, way) && isRight.test(way);
    return straight(m, goal)
        .flatMap(way -> firstFit(m, way, isClearAndRight))
        .or(
            () ->
                way(planner, free, m, goal)
                    .flatMap(
                        way ->
                            firstFit(m, way, isClearAndRight)
                                .or(() -> firstFit(m, overMiddle(free, m, way), isClearAndRight))));
  }

  /** From beside the middle of a cell the next one may lie behind a corner; from the middle not. */
  private List<Waypoint> overMiddle(OccupancyGrid free, Mover m, List<Waypoint> way) {
    List<Waypoint> longer = new ArrayList<>(way);
    longer.addFirst(new Waypoint(ground.grid().centre(entry(free, m)), true));
    return longer;
  }

  /** In an aisle hardly wider than the robot no cell's middle may be far enough from the walls. */
  private Optional<List<Waypoint>> straight(Mover m, Cell goal) {
    Vec2 point = m.goal;
    int side = Lanes.side(ground.grid(), 2 * m.radius);
    double near = NEAR * side * ground.grid().resolution();
    return side > 1
            && point != null
            && goal.equals(m.goalCell())
            && m.releasedEnd().position().distanceTo(point) < near
        ? Optional.of(List.of(new Waypoint(point, false)))
        : Optional.empty();
  }

  /** Robots so near to it that they touch the same cell. */
  private static List<Mover> beside(Mover m, Collection<Mover> others) {
    if (m.isDriving()) {
      return List.of();
    }
    BitSet under = new BitSet();
    m.standing().addTo(under);
    return others.stream().filter(o -> o != m && o.standing().intersects(under)).toList();
  }

  /**
   * Whether it touches nothing that stands fast. What it touches already, as it may have been
   * stopped anywhere and stands a little beside where it should, it comes no nearer to.
   */
  private boolean isClear(Mover m, List<Stretch> way) {
    OccupancyGrid grid = ground.grid();
    Pose pose = m.releasedEnd();
    BitSet touched = new BitSet();
    SweptCells.standing(grid, pose.position(), m.radius).addTo(touched);
    touched.and(ground.closed());
    if (touched.isEmpty()) {
      return isOffAll(way, ground.closed());
    }
    BitSet others = (BitSet) ground.closed().clone();
    others.andNot(touched);
    double gap = m.radius;
    for (int i = touched.nextSetBit(0); i >= 0; i = touched.nextSetBit(i + 1)) {
      gap = Math.min(gap, Disc.gap(grid, pose.position(), grid.cell(i)));
    }
    return isOffAll(way, others)
        && isOffAll(pose, way, Math.max(gap - ROUNDING, ROUNDING), touched);
  }

  /** Whether a disc of some radius on that way, which begins at a pose, touches no such cell. */
  private boolean isOffAll(Pose start, List<Stretch> way, double radius, BitSet cells) {
    Pose pose = start;
    for (Stretch stretch : way) {
      for (Segment segment : stretch.segments()) {
        if (SweptCells.of(ground.grid(), pose, segment, radius).intersects(cells)) {
          return false;
        }
        pose = pose.advanced(segment.twist(), segment.t());
      }
    }
    return true;
  }

  private static boolean meetsNobody(Mover m, List<Stretch> way, List<Mover> beside, BitSet taken) {
    return isOffAll(way, taken)
        && beside.stream().allMatch(o -> Clearance.isKept(m, m.releasedEnd(), way.getFirst(), o));
  }

  private static boolean isOffAll(List<Stretch> way, BitSet cells) {
    return way.stream().noneMatch(s -> s.cells().intersects(cells));
  }

  /** Where the way of a robot bends and ends; empty where there is none. */
  private Optional<List<Waypoint>> way(
      PathPlanner planner, OccupancyGrid free, Mover m, Cell goal) {
    OccupancyGrid grid = ground.grid();
    Cell entry = entry(free, m);
    Cell exit = exit(free, m, goal);
    List<Waypoint> way = new ArrayList<>();
    if (!entry.equals(m.releasedCell())) {
      way.add(new Waypoint(grid.centre(entry), false));
    }
    Optional<Path> path = path(planner, free, entry, exit);
    path.ifPresent(p -> way.addAll(p.waypoints(grid)));
    if (!exit.equals(goal) && m.goal != null) {
      way.add(new Waypoint(m.goal, false));
    } else if (way.isEmpty()) {
      way.add(new Waypoint(grid.centre(goal), false)); // in its cell, not in the middle
    }
    return path.map(p -> way);
  }

  /**
   * The cell in which its way over cells begins: where it stands, or beside that where the middle
   * of its cell is too near to something.
   */
  private Cell entry(OccupancyGrid free, Mover m) {
    Cell here = m.releasedCell();
    return ground.clear(m.radius).isFree(here) && isOpen(free, here)
        ? here
        : nearest(m.releasedEnd().position(), here, c -> !c.equals(here) && free.isFree(c));
  }

  private static boolean isOpen(OccupancyGrid free, Cell cell) {
    return free.isFree(cell.column() + 1, cell.row())
        || free.isFree(cell.column() - 1, cell.row())
        || free.isFree(cell.column(), cell.row() + 1)
        || free.isFree(cell.column(), cell.row() - 1);
  }

  /** The cell in which its way over cells ends: that of the goal, or beside it likewise. */
  private Cell exit(OccupancyGrid free, Mover m, Cell goal) {
    Vec2 point = m.goal;
    boolean isFine = Lanes.side(ground.grid(), 2 * m.radius) > 1;
    return isFine && !free.isFree(goal) && point != null && goal.equals(m.goalCell())
        ? nearest(point, goal, free::isFree)
        : goal;
  }

  /** The cell nearest to a point, of those beside its cell that are right; else that one itself. */
  private Cell nearest(Vec2 point, Cell here, Predicate<Cell> isRight) {
    return IntStream.rangeClosed(-BESIDE, BESIDE)
        .boxed()
        .flatMap(
            row ->
                IntStream.rangeClosed(-BESIDE, BESIDE)
                    .mapToObj(column -> new Cell(here.column() + column, here.row() + row)))
        .filter(isRight)
        .min(comparingDouble(cell -> ground.grid().centre(cell).distanceTo(point)))
        .orElse(here);
  }

  private static Optional<Path> path(
      PathPlanner planner, OccupancyGrid free, Cell start, Cell goal) {
    return planner.plan(free, start, goal) instanceof PlanResult.Found(Path path)
        ? Optional.of(path)
        : Optional.empty();
  }

  /** In wide arcs; where these touch something in narrow ones, and else turning on the spot. */
  private Optional<List<Stretch>> firstFit(
      Mover m, List<Waypoint> way, Predicate<List<Stretch>> isRight) {
    OccupancyGrid grid = ground.grid();
    int side = Lanes.side(grid, 2 * m.radius);
    double narrow = grid.resolution();
    Halts halts = side == 1 ? new Halts.Middles(grid) : new Halts.Spaced(side * narrow);
    List<Waypoint> exact = side == 1 ? way : toGoal(m, way);
    return Stream.<Supplier<List<Stretch>>>of(
            () -> fitter.fit(m, m.releasedEnd(), exact, side * narrow, halts),
            () -> fitter.fit(m, m.releasedEnd(), exact, narrow, halts),
            () -> fitter.fit(m, m.releasedEnd(), stopping(exact), narrow, halts))
        .map(Supplier::get)
        .filter(stretches -> !stretches.isEmpty())
        .filter(isRight)
        .findFirst();
  }

  /** The same way, ending at its goal itself if it ends in the cell of that. */
  private List<Waypoint> toGoal(Mover m, List<Waypoint> way) {
    Vec2 goal = m.goal;
    OccupancyGrid grid = ground.grid();
    if (goal == null || !grid.cellAt(way.getLast().position()).equals(grid.cellAt(goal))) {
      return way;
    }
    List<Waypoint> exact = new ArrayList<>(way);
    exact.set(way.size() - 1, new Waypoint(goal, false));
    return exact;
  }

  private static List<Waypoint> stopping(List<Waypoint> way) {
    return way.stream().map(w -> new Waypoint(w.position(), true)).toList();
  }
}
