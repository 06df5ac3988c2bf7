package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.IntPredicate;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;
import org.toqa.traffic.floor.ReservedPath.Dependency;

/**
 * Turns a plan for all robots into paths and the order in which they visit each cell.
 *
 * <p>The plan says who is where after each step; on a floor steps do not take equal time, so only
 * the order of the visits to each cell is kept: a robot enters a cell when whoever visits it before
 * has gone on. The order comes from a plan without collisions and without full rings, so it has no
 * cycle, and somebody can always drive (an action dependency graph: W. Hoenig et al., "Persistent
 * and robust execution of MAPF schedules in warehouses", RA-L 2019).
 */
final class JointPlan {
  /** A path is looked at so many times a lane cell to see which cell it is in. */
  private static final int PIECES = 8;

  /** So near to the middle of a cell, in cells, a point is in it and on no border. */
  private static final double INSIDE = 0.49;

  /** Robots that are so many lane cells apart keep their distance. */
  private static final int NEAR = 2;

  private final FreeSpace freeSpace;
  private final LanePoints lanes;
  private final OccupiedSpace occupied;
  private final RoadGraph roads;
  private final Spacing spacing;
  private final List<TrafficRobot> robots;
  private final List<int[]> steps;

  /** By lane cell: the robots that are planned from there. */
  private final Map<Cell, List<TrafficRobot>> byCell = new HashMap<>();

  /**
   * @param occupied where none of them must be
   * @param steps the vertices of the robots after each step, in the robots' order
   */
  JointPlan(
      FreeSpace freeSpace,
      LanePoints lanes,
      OccupiedSpace occupied,
      RoadGraph roads,
      Spacing spacing,
      List<TrafficRobot> robots,
      List<int[]> steps) {
    this.freeSpace = freeSpace;
    this.lanes = lanes;
    this.occupied = occupied;
    this.roads = roads;
    this.spacing = spacing;
    this.robots = robots;
    this.steps = steps;
    robots.forEach(
        robot ->
            byCell
                .computeIfAbsent(cell(robot.committedEnd()), cell -> new ArrayList<>())
                .add(robot));
  }

  private Cell cell(Pose pose) {
    return lanes.cells().cellAt(pose.position());
  }

  /**
   * One robot's stay on a cell.
   *
   * @param index of the visit on the robot's path
   * @param vertex of the cell
   * @param enters the step after which it is there
   */
  private record Visit(int robot, int index, int vertex, int enters) {}

  /** Gives every robot its path in the plan; one that does not move keeps what was released. */
  void adopt(SectionFitter fitter) {
    List<List<Visit>> visits = new ArrayList<>();
    Map<Integer, List<Visit>> byVertex = new HashMap<>();
    for (int robot = 0; robot < robots.size(); robot++) {
      visits.add(visitsOf(robot));
      visits
          .get(robot)
          .forEach(v -> byVertex.computeIfAbsent(v.vertex(), k -> new ArrayList<>()).add(v));
      List<Cell> cells = visits.get(robot).stream().map(v -> roads.cell(v.vertex())).toList();
      assignPath(robots.get(robot), cells, fitter);
    }
    byVertex.values().forEach(v -> v.sort(Comparator.comparingInt(Visit::enters)));
    for (int robot = 0; robot < robots.size(); robot++) {
      if (visits.get(robot).size() > 1) {
        robots.get(robot).drive.setDependencies(dependencies(visits.get(robot), byVertex));
      }
    }
  }

  private List<Visit> visitsOf(int robot) {
    List<Visit> visits = new ArrayList<>();
    int last = RoadGraph.NONE;
    for (int step = 0; step < steps.size(); step++) {
      int vertex = steps.get(step)[robot];
      if (vertex != last) {
        visits.add(new Visit(robot, visits.size(), vertex, step));
        last = vertex;
      }
    }
    return visits;
  }

  private void assignPath(TrafficRobot robot, List<Cell> visits, SectionFitter fitter) {
    if (visits.size() == 1) {
      robot.drive.freeUncommitted();
      return;
    }
    OccupancyGrid lattice = lanes.cells();
    Pose start = robot.committedEnd();
    List<Section> sections = sections(robot, start, visits, fitter);
    robot.continueOn(
        new ReservedPath(
            start,
            sections,
            0,
            lanes,
            visits,
            visitsAtEnds(lattice, start, sections, visits, 0),
            Collections.nCopies(visits.size(), List.of())));
  }

  /**
   * With round corners, where these keep as far from walls as turning on the spot does and the
   * robot is near the middle of its cell.
   */
  private List<Section> sections(
      TrafficRobot robot, Pose start, List<Cell> visits, SectionFitter fitter) {
    OccupancyGrid lattice = lanes.cells();
    PassingPlaces.CellPlaces passingPlaces =
        new PassingPlaces.CellPlaces(lattice, hasPlacesOnBorders());
    double length = lattice.resolution();
    List<Section> turning = turning(robot, start, visits, fitter, passingPlaces);
    if (!passingPlaces.isCentre(start.position())) {
      return turning;
    }
    List<Waypoint> waypoints = lanes.waypoints(visits, 0, goalPoint(robot, visits), i -> false);
    SweptArea standing = robot.areaAt(start);
    List<List<Section>> fits =
        Stream.of(length, length / 2)
            .map(corner -> fitter.fit(robot, start, waypoints, corner, passingPlaces))
            .filter(fit -> fit.stream().allMatch(s -> occupied.isFree(standing, s)))
            .filter(fit -> canSetOut(robot, fit) && keepsDirections(start, fit))
            .toList();
    for (double room : freeSpace.wallSteps()) {
      for (List<Section> fit : fits) {
        if (freeSpace.hasRoom(robot, fit, room)) {
          return fit;
        }
      }
      if (freeSpace.hasRoom(robot, turning, room)) {
        return turning;
      }
    }
    return fits.isEmpty() ? turning : fits.getFirst();
  }

  /**
   * Turning on the spot: through the middle of its own cell, where it may be beside it; else at
   * once to the next cell; else through the middle of that, as one that is too near to another
   * comes no nearer.
   */
  private List<Section> turning(
      TrafficRobot robot,
      Pose start,
      List<Cell> visits,
      SectionFitter fitter,
      PassingPlaces passingPlaces) {
    Vec2 goal = goalPoint(robot, visits);
    List<Waypoint> direct = lanes.waypoints(visits, 0, goal, i -> true);
    List<Waypoint> besides = new ArrayList<>(lanes.waypoints(visits, 1, goal, i -> true));
    besides.addFirst(new Waypoint(lanes.cells().centre(visits.get(1)), true));
    List<Section> first = null;
    for (List<Waypoint> waypoints :
        List.of(waypointsFromCentre(lanes, visits, 0, goal, i -> true), direct, besides)) {
      List<Section> fit =
          fitter.fit(robot, start, waypoints, lanes.cells().resolution(), passingPlaces);
      if (canSetOut(robot, fit) && keepsDirections(start, fit)) {
        return fit;
      }
      first = first == null ? fit : first;
    }
    return Objects.requireNonNull(first);
  }

  private boolean keepsDirections(Pose start, List<Section> path) {
    return DirectionCheck.isKept(roads.grid().rules(), start, path);
  }

  /** Where it stops in the cell of its goal, if it can go straight there from the cell before. */
  private @Nullable Vec2 goalPoint(TrafficRobot robot, List<Cell> visits) {
    Vec2 goal = lanes.goalPoint(robot);
    Vec2 before = lanes.of(visits.get(Math.max(0, visits.size() - 2)));
    return goal != null && roads.grid().rules().allows(before, goal) ? goal : null;
  }

  /** Whether nobody that is planned too stands so near that it keeps the robot from setting out. */
  private boolean canSetOut(TrafficRobot robot, List<Section> path) {
    Pose start = robot.committedEnd();
    SweptArea standing = robot.areaAt(start);
    Cell cell = cell(start);
    for (int row = cell.row() - NEAR; row <= cell.row() + NEAR; row++) {
      for (int column = cell.column() - NEAR; column <= cell.column() + NEAR; column++) {
        for (TrafficRobot other : byCell.getOrDefault(new Cell(column, row), List.of())) {
          if (other != robot
              && isNear(other.committedEnd(), start)
              && !path.isEmpty()
              && !Clearance.isKept(
                  standing, path.getFirst().area(), other.areaAt(other.committedEnd()))) {
            return false;
          }
        }
      }
    }
    return true;
  }

  /** Whether one may be nearer to the other than robots keep. */
  private boolean isNear(Pose one, Pose other) {
    double apart = spacing.isNone() ? 1 : NEAR;
    return one.distanceTo(other) < apart * lanes.cells().resolution();
  }

  /**
   * On cells of the floor itself that leave robots their distance. Where a lane cell is made of
   * several, goals are beside its middle, and who stops halfway could be planned to and fro.
   */
  private boolean hasPlacesOnBorders() {
    return spacing.isNone() && lanes.cells().width() == freeSpace.grid().width();
  }

  /** For each visit: of those who are there or too near to it, before, the last at each cell. */
  private List<List<Dependency>> dependencies(
      List<Visit> visits, Map<Integer, List<Visit>> byVertex) {
    List<List<Dependency>> dependencies = new ArrayList<>();
    for (Visit visit : visits) {
      List<Dependency> before = new ArrayList<>();
      addLastBefore(visit, byVertex.getOrDefault(visit.vertex(), List.of()), before);
      for (int vertex : spacing.near(visit.vertex())) {
        addLastBefore(visit, byVertex.getOrDefault(vertex, List.of()), before);
      }
      dependencies.add(List.copyOf(before));
    }
    return dependencies;
  }

  /** Who goes on from a cell before another comes: whoever stays until then is none of these. */
  private void addLastBefore(Visit visit, List<Visit> there, List<Dependency> before) {
    Visit last = null;
    for (Visit other : there) {
      if (other.enters() >= visit.enters()) {
        break;
      }
      last = other.robot() != visit.robot() && isOverAt(other, visit.enters()) ? other : last;
    }
    if (last != null) {
      TrafficRobot robot = robots.get(last.robot());
      before.add(new Dependency(robot.name, robot.drive.pathNumber(), last.index()));
    }
  }

  private boolean isOverAt(Visit visit, int step) {
    return steps.get(step)[visit.robot()] != visit.vertex();
  }

  /**
   * Where the path over the cells bends, from visit {@code from} on, through the middle of that
   * cell, for a robot that is beside it: from middle to middle the lanes are known to be wide
   * enough.
   */
  static List<Waypoint> waypointsFromCentre(
      LanePoints lanes, List<Cell> visits, int from, @Nullable Vec2 goal, IntPredicate stopsAt) {
    List<Waypoint> waypoints = new ArrayList<>();
    waypoints.add(new Waypoint(lanes.of(visits.get(from)), true));
    waypoints.addAll(lanes.waypoints(visits, from, goal, stopsAt));
    return waypoints;
  }

  /**
   * By section: which visit its end is. What is driven passes through the cells of the visits one
   * after the other, some of them perhaps more than once.
   *
   * @param start where the first section begins, in visit {@code from}
   */
  static List<Integer> visitsAtEnds(
      OccupancyGrid lattice, Pose start, List<Section> sections, List<Cell> visits, int from) {
    List<Integer> after = new ArrayList<>();
    int visit = from;
    Pose pose = start;
    for (Section section : sections) {
      for (Segment segment : section.segments()) {
        int pieces = 1 + (int) (PIECES * Math.abs(segment.length()) / lattice.resolution());
        for (int i = 0; i < pieces; i++) {
          pose = pose.advanced(segment.twist(), segment.t() / pieces);
          boolean isNext =
              visit + 1 < visits.size()
                  && isInside(lattice, visits.get(visit + 1), pose.position());
          visit += isNext ? 1 : 0;
        }
      }
      after.add(visit);
    }
    return after;
  }

  private static boolean isInside(OccupancyGrid lattice, Cell cell, Vec2 point) {
    Vec2 aside = point.minus(lattice.centre(cell));
    return Math.max(Math.abs(aside.x()), Math.abs(aside.y())) < INSIDE * lattice.resolution();
  }
}
