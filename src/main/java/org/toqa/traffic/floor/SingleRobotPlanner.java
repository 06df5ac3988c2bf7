package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.MoveRules;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.HeadingAStar;
import org.toqa.planning.Path;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanResult;
import org.toqa.traffic.RoadGraph;

/**
 * A robot's own shortest path in eight headings with round corners, as if it were alone or round
 * the others; or, who wants to set out now, on a smooth curve instead, where the floor is set so.
 */
final class SingleRobotPlanner {
  /** So many lane cells from its goal a robot may go straight there, in any heading. */
  private static final int NEAR = 3;

  /** So many times as long, in seconds, a path may be that keeps off walls. */
  private static final double DETOUR = 1.2;

  private static final double ROUNDING = 1e-4;

  private final FreeSpace freeSpace;
  private final SectionFitter fitter;
  private final PathEnds ends;
  private final FormationPlanner formationPlanner;

  /** Null: the floor's robots drive no smooth curves. */
  private final @Nullable SmoothPaths smoothPaths;

  private final PathPlanner planner = new HeadingAStar();

  SingleRobotPlanner(FreeSpace freeSpace, SectionFitter fitter, Moves moves) {
    this.freeSpace = freeSpace;
    this.fitter = fitter;
    this.ends = new PathEnds(freeSpace);
    this.formationPlanner = new FormationPlanner(freeSpace.grid(), freeSpace.margins(), fitter);
    this.smoothPaths = moves == Moves.SMOOTH ? new SmoothPaths(freeSpace, fitter) : null;
  }

  /** Another plan of the floor begins. */
  void begin() {
    if (smoothPaths != null) {
      smoothPaths.begin();
    }
  }

  /** As if no other robot were there; empty where the floor has no path. */
  Optional<List<Section>> pathAlone(TrafficRobot robot) {
    Cell goal = robot.goalCell();
    if (goal == null) {
      return Optional.empty();
    }
    FormationFootprint formation = robot.formation();
    if (formation != null) {
      return formationPath(robot, formation, List.of());
    }
    return roomiest(
        robot,
        room -> fittedPath(freeCells(robot, room, List.of()), robot, goal, sections -> true));
  }

  /**
   * One that keeps off walls where that is not much longer, else one that may come near to them.
   */
  private Optional<List<Section>> roomiest(
      TrafficRobot robot, DoubleFunction<Optional<List<Section>>> pathWithRoom) {
    Optional<List<Section>> near = pathWithRoom.apply(0);
    if (near.isEmpty() || LaneGrid.side(freeSpace.grid(), 2 * robot.radius()) == 1) {
      return near;
    }
    double longest = DETOUR * duration(near.get());
    return pathWithRoom
        .apply(freeSpace.margins().robot())
        .filter(roomy -> duration(roomy) <= longest || grazesWall(robot, near.get()))
        .or(() -> near);
  }

  private static double duration(List<Section> sections) {
    return sections.stream().mapToDouble(Section::duration).sum();
  }

  /**
   * As if all other robots made room that can: round groups that stand too where there is such a
   * way, since they step aside for nobody.
   */
  Optional<List<Section>> pathAroundStaying(TrafficRobot robot, Collection<TrafficRobot> robots) {
    return pathAround(robot, robots, other -> !other.isMovable() || stays(other))
        .or(
            () ->
                robots.stream().anyMatch(other -> other != robot && stays(other))
                    ? pathAround(robot, robots, other -> !other.isMovable())
                    : Optional.empty());
  }

  /** Whether it is a group that stands. */
  static boolean stays(TrafficRobot robot) {
    return robot.isFormation() && robot.drive.isOver();
  }

  /** As if all others were gone but some. */
  Optional<List<Section>> pathAround(
      TrafficRobot robot, Collection<TrafficRobot> robots, Predicate<TrafficRobot> isThere) {
    List<SweptArea> there =
        robots.stream()
            .filter(other -> other != robot && isThere.test(other))
            .flatMap(other -> other.claimed().stream())
            .toList();
    return there.isEmpty() ? pathAlone(robot) : pathAmong(robot, there);
  }

  /** The points of its path, were there neither robots nor obstacles; empty where there is none. */
  List<Vec2> pointsWithoutObstacles(TrafficRobot robot) {
    Cell goal = robot.goalCell();
    OccupancyGrid grid = freeSpace.grid();
    OccupancyGrid free = freeSpace.freeOfWalls(robot.radius());
    return goal == null
        ? List.of()
        : path(free, ends.entry(free, robot), goal).stream()
            .flatMap(path -> path.cells().stream())
            .map(grid::centre)
            .toList();
  }

  /**
   * Where its path leads against the direction of an area, were there no directions: metres, map
   * frame; empty where it does not, or there is none.
   */
  Optional<Vec2> pointAgainstDirection(TrafficRobot robot) {
    Cell goal = robot.goalCell();
    OccupancyGrid grid = freeSpace.grid();
    if (goal == null || !grid.rules().isDirected()) {
      return Optional.empty();
    }
    OccupancyGrid free =
        freeSpace.seenBy(robot).freeCells(robot.radius()).withRules(MoveRules.NONE);
    List<Vec2> points = new ArrayList<>(List.of(robot.committedEnd().position()));
    path(free, ends.entry(free, robot), ends.exit(free, robot, goal)).stream()
        .flatMap(path -> path.cells().stream())
        .map(grid::centre)
        .forEach(points::add);
    if (points.size() > 1 && robot.goal() != null) {
      points.add(robot.goal());
    }
    return IntStream.range(1, points.size())
        .filter(i -> !grid.rules().allows(points.get(i - 1), points.get(i)))
        .mapToObj(points::get)
        .findFirst();
  }

  /**
   * One that keeps off what is claimed.
   *
   * @param claimed what others have or will need
   */
  Optional<List<Section>> pathAmong(TrafficRobot robot, List<SweptArea> claimed) {
    Cell goal = robot.goalCell();
    FormationFootprint formation = robot.formation();
    if (goal == null) {
      return Optional.empty();
    }
    if (formation != null) {
      return formationPath(robot, formation, claimed);
    }
    return pathAmong(robot, claimed, (free, start) -> goal);
  }

  /** Forgets what it knows of robots that lead no formation any more. */
  void keepFormations(Collection<TrafficRobot> robots) {
    formationPlanner.keepOnly(
        robots.stream()
            .filter(TrafficRobot::isFormation)
            .map(robot -> robot.name)
            .collect(Collectors.toSet()));
  }

  /** One that keeps off what is claimed, for who wants to set out now. */
  Optional<List<Section>> pathNow(TrafficRobot robot, List<SweptArea> claimed, Instant now) {
    FormationFootprint formation = robot.formation();
    Vec2 goal = robot.goal();
    return formation == null || goal == null
        ? pathAmong(robot, claimed).map(straight -> smoothInstead(robot, claimed, straight))
        : formationPlanner.freePath(
            robot, formation, goal, freeSpace.seenBy(robot).blocked(), claimed, now);
  }

  /**
   * A smooth path instead of another one, if it keeps as much room from walls, takes not much
   * longer, and keeps all else that the other one keeps.
   */
  private List<Section> smoothInstead(
      TrafficRobot robot, List<SweptArea> claimed, List<Section> straight) {
    if (smoothPaths == null) {
      return straight;
    }
    double longest = DETOUR * duration(straight);
    double room = room(robot, straight);
    return smoothPaths
        .first(
            robot,
            claimed,
            smooth ->
                duration(smooth) <= longest
                    && isClearAndRight(robot, smooth)
                    && keepsOff(robot, smooth, claimed)
                    && room(robot, smooth) >= room)
        .orElse(straight);
  }

  private Optional<List<Section>> formationPath(
      TrafficRobot robot, FormationFootprint formation, List<SweptArea> claimed) {
    Vec2 goal = robot.goal();
    return goal == null
        ? Optional.empty()
        : formationPlanner.path(robot, formation, goal, freeSpace.seenBy(robot).blocked(), claimed);
  }

  /**
   * One that keeps off what is claimed, to the nearest place away from some areas; into none where
   * it would graze a wall.
   *
   * @param left what it has to leave
   */
  Optional<List<Section>> pathOutOf(
      TrafficRobot robot, List<SweptArea> claimed, List<SweptArea> left) {
    return robot.formation() != null
        ? Optional.empty()
        : pathAmong(robot, claimed, (free, start) -> nearestOutside(free, start, robot, left))
            .filter(sections -> !grazesWall(robot, sections));
  }

  /** Where to go on a floor, if anywhere. */
  private interface GoalChoice {
    @Nullable Cell from(OccupancyGrid free, Cell start);
  }

  private @Nullable Cell nearestOutside(
      OccupancyGrid free, Cell start, TrafficRobot robot, List<SweptArea> left) {
    RoadGraph roads = new RoadGraph(free);
    LanePoints points = freeSpace.seenBy(robot).points(robot.radius());
    int[] found = {RoadGraph.NONE};
    roads.visitByDistance(
        roads.vertex(start),
        (vertex, steps) -> {
          SweptArea place = SweptArea.at(points.of(roads.cell(vertex)), robot.radius());
          boolean isOutside = left.stream().allMatch(area -> Clearance.isKept(place, area));
          found[0] = isOutside ? vertex : RoadGraph.NONE;
          return !isOutside;
        });
    return found[0] == RoadGraph.NONE ? null : roads.cell(found[0]);
  }

  /** One that comes near to walls only where it would do so alone too. */
  private Optional<List<Section>> pathAmong(
      TrafficRobot robot, List<SweptArea> claimed, GoalChoice aim) {
    Optional<List<Section>> path = roomiest(robot, room -> pathAmong(robot, room, claimed, aim));
    if (claimed.isEmpty() || path.filter(sections -> grazesWall(robot, sections)).isEmpty()) {
      return path;
    }
    return roomiest(robot, room -> pathAmong(robot, room, List.of(), aim))
            .filter(alone -> !grazesWall(robot, alone))
            .isPresent()
        ? Optional.empty()
        : path;
  }

  private Optional<List<Section>> pathAmong(
      TrafficRobot robot, double room, List<SweptArea> claimed, GoalChoice aim) {
    OccupancyGrid free = freeCells(robot, room, claimed);
    Cell goal = aim.from(free, ends.entry(free, robot));
    if (goal == null) {
      return Optional.empty();
    }
    return fittedPath(free, robot, goal, sections -> keepsOff(robot, sections, claimed));
  }

  private static boolean keepsOff(
      TrafficRobot robot, List<Section> sections, List<SweptArea> claimed) {
    SweptArea standing = robot.areaAt(robot.committedEnd());
    return sections.stream()
        .allMatch(
            section ->
                claimed.stream()
                    .allMatch(area -> Clearance.isKept(standing, section.area(), area)));
  }

  private OccupancyGrid freeCells(TrafficRobot robot, double room, List<SweptArea> claimed) {
    SweptArea standing = robot.areaAt(robot.committedEnd());
    return freeSpace
        .seenBy(robot)
        .freeCells(robot.radius(), room, claimed, standing, robot.committedCell());
  }

  /**
   * Clear of walls and obstacles; straight to a goal that is near, over cells, or first to the
   * middle of its own cell: the first that keeps its margin, else what keeps the most room.
   */
  private Optional<List<Section>> fittedPath(
      OccupancyGrid free, TrafficRobot robot, Cell goal, Predicate<List<Section>> isAcceptable) {
    Predicate<List<Section>> isClearAndRight =
        sections -> isClearAndRight(robot, sections) && isAcceptable.test(sections);
    Optional<List<Section>> best =
        straightToGoal(robot, goal)
            .flatMap(waypoints -> firstFit(robot, waypoints, isClearAndRight));
    if (keepsMargin(robot, best)) {
      return best;
    }
    Optional<List<Waypoint>> overCells = waypoints(free, robot, goal);
    best =
        roomier(
            robot,
            best,
            overCells.flatMap(waypoints -> firstFit(robot, waypoints, isClearAndRight)));
    return keepsMargin(robot, best)
        ? best
        : roomier(
            robot,
            best,
            overCells.flatMap(
                waypoints ->
                    firstFit(robot, viaCellCentre(free, robot, waypoints), isClearAndRight)));
  }

  private boolean isClearAndRight(TrafficRobot robot, List<Section> sections) {
    return isClear(robot, sections)
        && DirectionCheck.isKept(freeSpace.grid().rules(), robot.committedEnd(), sections);
  }

  private boolean keepsMargin(TrafficRobot robot, Optional<List<Section>> path) {
    return path.filter(sections -> room(robot, sections) == freeSpace.margins().robot())
        .isPresent();
  }

  /** The path that keeps more room, the first of those alike. */
  private Optional<List<Section>> roomier(
      TrafficRobot robot, Optional<List<Section>> first, Optional<List<Section>> second) {
    return Stream.of(first, second)
        .flatMap(Optional::stream)
        .max(Comparator.comparingDouble(path -> room(robot, path)));
  }

  /** Whether a path keeps less from walls than robots keep where they have little room. */
  private boolean grazesWall(TrafficRobot robot, List<Section> path) {
    return room(robot, path) < 0;
  }

  /** What a path keeps from walls, metres: one of the steps; below 0: none of them. */
  private double room(TrafficRobot robot, List<Section> path) {
    return freeSpace.wallSteps().stream()
        .filter(room -> freeSpace.seenBy(robot).hasRoom(robot, path, room))
        .findFirst()
        .orElse(-1.0);
  }

  /** From beside the middle of a cell the next one may lie behind a corner; from the middle not. */
  private List<Waypoint> viaCellCentre(
      OccupancyGrid free, TrafficRobot robot, List<Waypoint> waypoints) {
    List<Waypoint> longer = new ArrayList<>(waypoints);
    longer.addFirst(new Waypoint(freeSpace.grid().centre(ends.entry(free, robot)), true));
    return longer;
  }

  /** In an aisle hardly wider than the robot no cell's middle may be far enough from the walls. */
  private Optional<List<Waypoint>> straightToGoal(TrafficRobot robot, Cell goal) {
    Vec2 point = robot.goal();
    int side = LaneGrid.side(freeSpace.grid(), 2 * robot.radius());
    double near = NEAR * side * freeSpace.grid().resolution();
    return side > 1
            && point != null
            && goal.equals(robot.goalCell())
            && robot.committedEnd().position().distanceTo(point) < near
        ? Optional.of(List.of(new Waypoint(point, false)))
        : Optional.empty();
  }

  /**
   * Whether it touches no wall and no obstacle. What it touches already, as it may have been
   * stopped anywhere and is a little beside where it should be, it comes no nearer to.
   */
  private boolean isClear(TrafficRobot robot, List<Section> sections) {
    OccupancyGrid grid = freeSpace.grid();
    BitSet blocked = freeSpace.seenBy(robot).blocked();
    Pose pose = robot.committedEnd();
    BitSet touched = new BitSet();
    robot.areaAt(pose).cells(grid, 0).addTo(touched);
    touched.and(blocked);
    if (touched.isEmpty()) {
      return isClearOf(sections, blocked);
    }
    BitSet others = (BitSet) blocked.clone();
    others.andNot(touched);
    double gap = Math.min(robot.radius(), freeSpace.distance(pose.position(), touched));
    return isClearOf(sections, others)
        && freeSpace.isClearOf(pose, sections, Math.max(gap - ROUNDING, ROUNDING), touched);
  }

  private static boolean isClearOf(List<Section> sections, BitSet cells) {
    return sections.stream().noneMatch(s -> s.cells().intersects(cells));
  }

  /** Where the path of a robot bends and ends; empty where there is none. */
  private Optional<List<Waypoint>> waypoints(OccupancyGrid free, TrafficRobot robot, Cell goal) {
    OccupancyGrid grid = freeSpace.grid();
    Cell entry = ends.entry(free, robot);
    Cell exit = ends.exit(free, robot, goal);
    List<Waypoint> waypoints = new ArrayList<>();
    if (!entry.equals(robot.committedCell())) {
      waypoints.add(new Waypoint(grid.centre(entry), false));
    }
    Optional<Path> path = path(free, entry, exit);
    path.ifPresent(p -> waypoints.addAll(waypoints(p, robot)));
    if (!exit.equals(goal) && robot.goal() != null) {
      waypoints.add(new Waypoint(robot.goal(), false));
    } else if (waypoints.isEmpty()) {
      Vec2 point = freeSpace.seenBy(robot).points(robot.radius()).goalPoint(robot);
      waypoints.add(new Waypoint(point == null ? grid.centre(goal) : point, false)); // in its cell
    }
    return path.map(p -> waypoints);
  }

  /** Where the path bends or the robot turns on the spot, and its end. */
  private List<Waypoint> waypoints(Path path, TrafficRobot robot) {
    List<Cell> cells = new ArrayList<>();
    BitSet turns = new BitSet();
    for (Path.Step step : path.steps()) {
      if (!cells.isEmpty() && cells.getLast().equals(step.cell())) {
        turns.set(cells.size() - 1);
      } else {
        cells.add(step.cell());
      }
    }
    LanePoints points = freeSpace.seenBy(robot).points(robot.radius());
    return points.waypoints(cells, 0, points.goalPoint(robot), turns::get);
  }

  private Optional<Path> path(OccupancyGrid free, Cell start, Cell goal) {
    return planner.plan(free, start, goal) instanceof PlanResult.Found(Path path)
        ? Optional.of(path)
        : Optional.empty();
  }

  /** In the widest arcs that keep from walls what turning on the spot keeps, if that is little. */
  private Optional<List<Section>> firstFit(
      TrafficRobot robot, List<Waypoint> waypoints, Predicate<List<Section>> isAcceptable) {
    OccupancyGrid grid = freeSpace.grid();
    int side = LaneGrid.side(grid, 2 * robot.radius());
    double narrow = grid.resolution();
    PassingPlaces passingPlaces =
        side == 1
            ? new PassingPlaces.CellPlaces(grid, false)
            : new PassingPlaces.Spaced(side * narrow);
    List<Waypoint> exact = side == 1 ? waypoints : endingAtGoal(robot, waypoints);
    List<List<Section>> fits =
        Stream.concat(
                DoubleStream.of(side, Math.max(1, side / 2.0), 0.5)
                    .distinct()
                    .mapToObj(
                        cells ->
                            fitter.fit(
                                robot, robot.committedEnd(), exact, cells * narrow, passingPlaces)),
                Stream.of(
                    fitter.fit(
                        robot, robot.committedEnd(), stopping(exact), narrow, passingPlaces)))
            .filter(sections -> !sections.isEmpty() && isAcceptable.test(sections))
            .toList();
    return fits.stream().max(Comparator.comparingDouble(path -> room(robot, path)));
  }

  /** The same path, ending at its goal itself if it ends in the cell of that. */
  private List<Waypoint> endingAtGoal(TrafficRobot robot, List<Waypoint> waypoints) {
    Vec2 goal = robot.goal();
    OccupancyGrid grid = freeSpace.grid();
    if (goal == null || !grid.cellAt(waypoints.getLast().position()).equals(grid.cellAt(goal))) {
      return waypoints;
    }
    List<Waypoint> exact = new ArrayList<>(waypoints);
    exact.set(waypoints.size() - 1, new Waypoint(goal, false));
    return exact;
  }

  private static List<Waypoint> stopping(List<Waypoint> waypoints) {
    return waypoints.stream().map(w -> new Waypoint(w.position(), true)).toList();
  }
}
