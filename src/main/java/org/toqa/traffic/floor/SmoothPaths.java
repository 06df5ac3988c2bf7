package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.BiarcFitter;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.PlanningBudget;
import org.toqa.planning.smooth.SmoothMethod;
import org.toqa.planning.smooth.SmoothPlanner;
import org.toqa.planning.smooth.SmoothResult;
import org.toqa.planning.smooth.WayPath;
import org.toqa.planning.smooth.curve.SmoothCurve;
import org.toqa.planning.smooth.curve.SplineFitter;

/**
 * Paths of robots that drive alone as smooth curves of their discs, for floors whose setting says
 * so ({@link org.toqa.grid.Moves#SMOOTH}).
 *
 * <p>A path keeps the robot's margin from walls and obstacles; where it begins or ends nearer to
 * them, it eases away from there. It is looked for as if nobody were there, and where that is no
 * use, on a floor that is small enough, round what others have. Directions of areas it does not
 * know: whoever asks looks at what comes out. The search has a seed and ends after so many
 * iterations, so the same picture of a floor has the same paths. Confined to one thread.
 */
final class SmoothPaths {
  private static final long SEED = 7276;

  private static final int ITERATIONS = 1000;

  /** Searches for one plan of the floor; who comes after these drives otherwise. */
  private static final int MOST_SEARCHES = 16;

  /** Cells; what is near to each of them is kept. */
  private static final int MOST_CELLS = 1 << 20;

  /** Cells; so small a floor is laid out anew with what others have. */
  private static final int FEW_CELLS = 50_000;

  /** Each by obstacles, and the size and margin of a robot. */
  private static final int MOST_LAYOUTS = 8;

  /**
   * Metres more than the margin: segments are within 0.001 m of their curve, and the chords by
   * which an arc is looked at within 0.0005 m of the arc.
   */
  private static final double SLACK = 0.002;

  /** Metres; a path from one point to another so near to it has no curve. */
  private static final double SHORTEST = 0.05;

  /** Metres and angles at which a free point beside one that is not is looked for. */
  private static final double STEP_ASIDE = 0.01;

  private static final int STEPS_ASIDE = 12;
  private static final int DIRECTIONS = 16;

  /** Of the radius: within so much a path comes to its margin, if it begins nearer to a wall. */
  private static final double[] EASES = {4, 2, 1, 0};

  /** Radians; no smaller turn is driven at the end. */
  private static final double SMALLEST_TURN = 1e-6;

  private final FreeSpace freeSpace;
  private final SectionFitter fitter;
  private final SmoothPlanner planner = new SmoothPlanner(SmoothMethod.HYBRID, SEED);
  private final Map<Layout, DiscSpace> layouts = new LinkedHashMap<>(16, 0.75f, true);
  private int searchesLeft;

  private record Layout(BitSet blocked, double radius) {}

  SmoothPaths(FreeSpace freeSpace, SectionFitter fitter) {
    this.freeSpace = freeSpace;
    this.fitter = fitter;
  }

  /** Another plan of the floor begins. */
  void begin() {
    searchesLeft = MOST_SEARCHES;
  }

  /**
   * The first one that may be driven; those with more room from walls come first.
   *
   * @param claimed what others have or will need
   */
  Optional<List<Section>> first(
      TrafficRobot robot, List<SweptArea> claimed, Predicate<List<Section>> isAcceptable) {
    OccupancyGrid grid = freeSpace.grid();
    Vec2 goal = goalPoint(robot);
    int cells = grid.width() * grid.height();
    if (goal == null
        || cells > MOST_CELLS
        || robot.committedEnd().position().distanceTo(goal) < SHORTEST) {
      return Optional.empty();
    }
    BitSet blocked = freeSpace.seenBy(robot).blocked();
    for (double room : freeSpace.wallSteps()) {
      Optional<List<Section>> path =
          path(robot, goal, laidOut(blocked, robot.radius() + room + SLACK), blocked)
              .filter(isAcceptable);
      if (path.isEmpty() && !claimed.isEmpty() && cells <= FEW_CELLS) {
        BitSet taken = withClaimed(blocked, claimed, room);
        DiscSpace space = DiscSpace.of(grid.withOccupied(taken), robot.radius() + room + SLACK);
        path = path(robot, goal, space, blocked).filter(isAcceptable);
      }
      if (path.isPresent()) {
        return path;
      }
    }
    return Optional.empty();
  }

  /** Where it is to stop: where its goal counts as a cell, in that, else at the goal itself. */
  private @Nullable Vec2 goalPoint(TrafficRobot robot) {
    return LaneGrid.side(freeSpace.grid(), 2 * robot.radius()) == 1
        ? freeSpace.seenBy(robot).points(robot.radius()).goalPoint(robot)
        : robot.goal();
  }

  private DiscSpace laidOut(BitSet blocked, double radius) {
    DiscSpace space =
        layouts.computeIfAbsent(
            new Layout(blocked, radius),
            key -> DiscSpace.of(freeSpace.grid().withOccupied(key.blocked()), key.radius()));
    if (layouts.size() > MOST_LAYOUTS) {
      layouts.remove(layouts.keySet().iterator().next());
    }
    return space;
  }

  /** Who keeps its room from these cells keeps its distance from others. */
  private BitSet withClaimed(BitSet blocked, List<SweptArea> claimed, double room) {
    BitSet taken = (BitSet) blocked.clone();
    double near = Math.max(0, Clearance.BETWEEN_ROBOTS - room);
    claimed.forEach(area -> area.cells(freeSpace.grid(), near).addTo(taken));
    return taken;
  }

  /**
   * @param space where the robot keeps its margin
   * @param blocked what it must not touch
   */
  private Optional<List<Section>> path(
      TrafficRobot robot, Vec2 goal, DiscSpace space, BitSet blocked) {
    Pose start = robot.committedEnd();
    Vec2 entry = freePointNear(space, start.position());
    Vec2 exit = freePointNear(space, goal);
    if (entry == null || exit == null || searchesLeft == 0) {
      return Optional.empty();
    }
    searchesLeft--;
    SmoothResult result = planner.plan(space, entry, exit, PlanningBudget.iterations(ITERATIONS));
    if (!(result instanceof SmoothResult.Found(WayPath path))) {
      return Optional.empty();
    }
    boolean hasRoomAtEnds = entry.equals(start.position()) && exit.equals(goal);
    DiscSpace fitting = hasRoomAtEnds ? space : laidOut(blocked, robot.radius() + SLACK);
    return eased(fitting, start.position(), path.points())
        .flatMap(points -> eased(fitting, goal, points.reversed()))
        .map(points -> sections(robot, fitting, points.reversed()));
  }

  /** The point itself, or one beside it, where there is any. */
  private static @Nullable Vec2 freePointNear(DiscSpace space, Vec2 point) {
    if (space.isFree(point)) {
      return point;
    }
    for (int step = 1; step <= STEPS_ASIDE; step++) {
      Vec2 aside = new Vec2(step * STEP_ASIDE, 0);
      for (int i = 0; i < DIRECTIONS; i++) {
        Vec2 beside = point.plus(aside.rotated(2 * Math.PI * i / DIRECTIONS));
        if (space.isFree(beside)) {
          return beside;
        }
      }
    }
    return null;
  }

  /**
   * The path, beginning where it really does: from there it comes to itself within some radii.
   *
   * @param path from a point beside that
   */
  private static Optional<List<Vec2>> eased(DiscSpace space, Vec2 from, List<Vec2> path) {
    if (path.getFirst().equals(from)) {
      return Optional.of(path);
    }
    for (double radii : EASES) {
      List<Vec2> points = new ArrayList<>(restAfter(path, radii * space.radius()));
      if (space.isFree(from, points.getFirst())) {
        points.addFirst(from);
        return Optional.of(points);
      }
    }
    return Optional.empty();
  }

  /** What comes behind so many metres of it; its last point at least. */
  private static List<Vec2> restAfter(List<Vec2> path, double metres) {
    double left = metres;
    for (int i = 1; i < path.size(); i++) {
      Vec2 from = path.get(i - 1);
      double leg = from.distanceTo(path.get(i));
      if (left < leg) {
        List<Vec2> rest = new ArrayList<>(path.subList(i, path.size()));
        rest.addFirst(from.plus(path.get(i).minus(from).times(left / leg)));
        return rest;
      }
      left -= leg;
    }
    return List.of(path.getLast());
  }

  private List<Section> sections(TrafficRobot robot, DiscSpace space, List<Vec2> points) {
    Pose start = robot.committedEnd();
    Double heading = robot.requiredHeadingAt(points.getLast());
    SmoothCurve curve = new SplineFitter(space).fit(points, start.theta(), heading);
    List<Segment> segments =
        new ArrayList<>(
            new BiarcFitter(robot.speeds()).fit(start.theta(), curve.pieces()).segments());
    if (heading != null) {
      double rate = robot.speeds().spotRate();
      double turn = Angles.difference(new Trajectory(start, segments).end().theta(), heading);
      if (Math.abs(turn) > SMALLEST_TURN) {
        segments.add(new Segment(0, Math.copySign(rate, turn), Math.abs(turn) / rate));
      }
    }
    OccupancyGrid grid = freeSpace.grid();
    double spacing = LaneGrid.side(grid, 2 * robot.radius()) * grid.resolution();
    List<Segment> pieces = segments.stream().flatMap(s -> cut(s, spacing).stream()).toList();
    return fitter.split(robot, new Trajectory(start, pieces), new PassingPlaces.Spaced(spacing));
  }

  /** An arc in pieces no longer than the robot may drive without a place to stop. */
  private static List<Segment> cut(Segment segment, double spacing) {
    if (segment.w() == 0 || segment.v() == 0) {
      return List.of(segment);
    }
    int count = (int) Math.max(1, Math.ceil(segment.length() / spacing));
    Segment piece = new Segment(segment.v(), segment.w(), segment.t() / count);
    return Collections.nCopies(count, piece);
  }
}
