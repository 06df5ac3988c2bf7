package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.formation.TrajectoryRules;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;
import org.toqa.planning.Heading;
import org.toqa.planning.OpenList;

/**
 * Paths that a formation can be led along: A* for the leader over the points of a lattice and eight
 * headings. A move is a step along the heading, or a corner of 45 degrees with as much of a leg
 * before and behind it as an arc of the smallest radius needs, so that no path has a tighter one;
 * it is open where the whole formation, with a margin, meets nothing on it. The first leg leads
 * from where the leader faces onto the lattice.
 *
 * <p>The cost is that of a search over eight states a point. Confined to one thread.
 */
final class FormationPlanner {
  /** Kept from walls while a path is looked for, metres. */
  private static final double MARGIN = 0.02;

  /** Lattice points are at most so far apart, metres. */
  private static final double WIDEST_STEP = 0.15;

  /** The path onto the lattice is no longer, metres. */
  private static final double LONGEST_ENTRY = 1.5;

  /** So far beside the lattice, metres, a parallel path onto it may begin. */
  private static final double MAX_ASIDE = 0.06;

  /** A robot that has come to its place is no farther from it, metres. */
  private static final double PLACE_TOLERANCE = 0.01;

  /** Radians. */
  private static final double HEADING_TOLERANCE = 0.02;

  /** Radians; below it two directions are parallel. */
  private static final double PARALLEL = 0.01;

  private static final double ROUNDING = 1e-6;
  private static final Heading[] HEADINGS = Heading.values();
  private static final double EIGHTH = Math.PI / 4;

  /** Sections end at least so far apart, metres. */
  private static final double PASSING_PLACE_SPACING = 0.3;

  private final OccupancyGrid grid;
  private final SectionFitter fitter;
  private final double step;
  private final Vec2 firstPoint;
  private final int columns;
  private final int rows;

  FormationPlanner(OccupancyGrid grid, SectionFitter fitter) {
    this.grid = grid;
    this.fitter = fitter;
    double cell = grid.resolution();
    this.step = step(grid);
    this.firstPoint = firstPoint(grid);
    this.columns = (int) ((grid.width() - 1) * cell / step + ROUNDING) + 1;
    this.rows = (int) ((grid.height() - 1) * cell / step + ROUNDING) + 1;
  }

  private static double step(OccupancyGrid grid) {
    double cell = grid.resolution();
    return cell > WIDEST_STEP
        ? cell / Math.ceil(cell / WIDEST_STEP)
        : cell * Math.floor(WIDEST_STEP / cell);
  }

  /** The lattice point in the middle of the cell in the south-west. */
  private static Vec2 firstPoint(OccupancyGrid grid) {
    double cell = grid.resolution();
    return grid.origin().plus(new Vec2(cell / 2, cell / 2));
  }

  /**
   * Where the path of a formation begins whose leader is there: on the lattice if it is but for
   * what a robot may be off its place. It is drawn onto its path as it sets out; a path that began
   * beside the lattice would need room to get onto it, which a place between machines has not.
   */
  static Pose start(OccupancyGrid grid, Pose leader) {
    double step = step(grid);
    Vec2 first = firstPoint(grid);
    Pose onLattice =
        new Pose(
            first.x() + Math.rint((leader.x() - first.x()) / step) * step,
            first.y() + Math.rint((leader.y() - first.y()) / step) * step,
            Heading.nearest(leader.theta()).ordinal() * EIGHTH);
    return isAtPlace(onLattice, leader) ? onLattice : leader;
  }

  /** Whether who was sent to a place has come there. */
  static boolean isAtPlace(Pose place, Pose pose) {
    return place.distanceTo(pose) < PLACE_TOLERANCE
        && Math.abs(Angles.difference(pose.theta(), place.theta())) < HEADING_TOLERANCE;
  }

  /** Metres that the load may be beside its goal. */
  static double goalTolerance(OccupancyGrid grid) {
    return Math.min(WIDEST_STEP, Math.max(grid.resolution(), WIDEST_STEP / 2)) * 0.8;
  }

  /**
   * The shortest path on which the formation meets none of these cells.
   *
   * @param goal where the load is carried, metres, map frame
   */
  Optional<List<Section>> path(
      TrafficRobot robot, FormationFootprint formation, Vec2 goal, BitSet blocked) {
    Pose start = robot.releasedEnd();
    TrajectoryRules rules = new TrajectoryRules(formation.shape(), robot.speeds().forward());
    SegmentFitter arcs = new SegmentFitter(robot.speeds(), rules.cornerLength(EIGHTH));
    return new Search(formation, start, goal, blocked, arcs)
        .waypoints()
        .map(waypoints -> rules.slowed(arcs.fit(start, waypoints)))
        .filter(trajectory -> rules.firstBreach(trajectory).isEmpty())
        .map(trajectory -> sections(robot, trajectory))
        .filter(
            sections ->
                !sections.isEmpty()
                    && sections.stream().noneMatch(s -> s.cells().intersects(blocked)));
  }

  private List<Section> sections(TrafficRobot robot, Trajectory trajectory) {
    return fitter.split(
        robot,
        trajectory,
        new PassingPlaces.Spaced(Math.max(PASSING_PLACE_SPACING, grid.resolution())));
  }

  /** One search; a state is {@code 8 (row columns + column) + heading}. */
  private final class Search {
    private final FormationFootprint formation;
    private final Pose start;
    private final Vec2 goal;
    private final BitSet blocked;
    private final SegmentFitter arcs;
    private final double radius;
    private final double[] lengths = new double[HEADINGS.length * columns * rows];
    private final int[] parents = new int[lengths.length];
    private final byte[] open = new byte[lengths.length];
    private final Map<Integer, List<Vec2>> entries = new HashMap<>();
    private final OpenList openList = new OpenList();

    /** States that have been reached and not expanded since. */
    private final BitSet reached = new BitSet();

    Search(
        FormationFootprint formation, Pose start, Vec2 goal, BitSet blocked, SegmentFitter arcs) {
      this.formation = formation;
      this.start = start;
      this.goal = goal;
      this.blocked = blocked;
      this.arcs = arcs;
      this.radius = formation.shape().smallestRadius();
      Arrays.fill(lengths, Double.POSITIVE_INFINITY);
      Arrays.fill(parents, -1);
    }

    /** Where the path bends and ends. */
    Optional<List<Waypoint>> waypoints() {
      enter();
      while (!openList.isEmpty()) {
        int state = openList.pop();
        if (!reached.get(state)) {
          continue;
        }
        reached.clear(state);
        if (isGoal(state)) {
          return Optional.of(waypointsTo(state));
        }
        expand(state);
      }
      return Optional.empty();
    }

    private boolean isGoal(int state) {
      return formation.shape().loadAt(pose(state)).position().distanceTo(goal)
          < goalTolerance(grid);
    }

    private void expand(int state) {
      int heading = state & 7;
      advance(state, heading, 1, heading, 0);
      for (int turn = -1; turn <= 1; turn += 2) {
        int next = heading + turn & 7;
        advance(state, heading, legs(heading), next, legs(next));
      }
    }

    /** So many steps of a heading that an arc of 45 degrees has room on them. */
    private int legs(int heading) {
      return (int) Math.ceil(tangent(EIGHTH) / length(heading) - ROUNDING);
    }

    // t = R tan(angle/2)
    private double tangent(double angle) {
      return radius * Math.tan(Math.abs(angle) / 2);
    }

    private double length(int heading) {
      return (heading & 1) == 0 ? step : step * Math.sqrt(2);
    }

    /** Steps along one heading, and then some along the next. */
    private void advance(int state, int heading, int count, int then, int countThen) {
      int at = state;
      for (int i = 1; i <= count; i++) {
        at = neighbour(at, heading);
        boolean isInArc = countThen > 0 && i == count;
        if (at < 0 || (!isInArc && !isOpen(at))) {
          return;
        }
      }
      for (int i = 1; i <= countThen; i++) {
        at = neighbour((at & ~7) | then, then);
        if (at < 0 || !isOpen(at)) {
          return;
        }
      }
      if (countThen > 0 && !isArcOpen(state, heading, count, then)) {
        return;
      }
      double length = lengths[state] + count * length(heading) + countThen * length(then);
      reach(at, state, length);
    }

    private boolean isArcOpen(int state, int heading, int count, int then) {
      double tangent = tangent(EIGHTH);
      double before = count * length(heading) - tangent;
      Pose pose = pose(state).compose(new Pose(before, 0, 0));
      double turn = (then - heading + 12 & 7) == 5 ? EIGHTH : -EIGHTH;
      int pieces = Math.max(3, (int) Math.ceil(radius * EIGHTH / step));
      for (int i = 0; i < pieces; i++) {
        double angle = turn / pieces;
        pose = pose.advanced(new Twist(radius * Math.abs(angle), 0, angle), 1);
        if (!formation.isClearOf(grid, pose, MARGIN, blocked)) {
          return false;
        }
      }
      return true;
    }

    private void reach(int state, int from, double length) {
      if (length < lengths[state] - ROUNDING) {
        lengths[state] = length;
        parents[state] = from;
        double rest = formation.shape().loadAt(pose(state)).position().distanceTo(goal);
        reached.set(state);
        openList.push(state, length + rest);
      }
    }

    private int neighbour(int state, int heading) {
      int point = state >> 3;
      int column = point % columns + HEADINGS[heading].dColumn();
      int row = point / columns - HEADINGS[heading].dRow();
      return column < 0 || row < 0 || column >= columns || row >= rows
          ? -1
          : 8 * (row * columns + column) + heading;
    }

    private boolean isOpen(int state) {
      if (open[state] == 0) {
        open[state] = (byte) (formation.isClearOf(grid, pose(state), MARGIN, blocked) ? 1 : 2);
      }
      return open[state] == 1;
    }

    private Pose pose(int state) {
      int point = state >> 3;
      int column = point % columns;
      int row = point / columns;
      return new Pose(
          firstPoint.x() + column * step, firstPoint.y() + row * step, (state & 7) * EIGHTH);
    }

    /** The paths onto the lattice: straight ahead, one corner, and straight again. */
    private void enter() {
      int reach = (int) Math.ceil(LONGEST_ENTRY / step);
      int column = (int) Math.round((start.x() - firstPoint.x()) / step);
      int row = (int) Math.round((start.y() - firstPoint.y()) / step);
      int nearest = Heading.nearest(start.theta()).ordinal();
      for (int r = Math.max(0, row - reach); r <= Math.min(rows - 1, row + reach); r++) {
        for (int c = Math.max(0, column - reach); c <= Math.min(columns - 1, column + reach); c++) {
          for (int turn = -1; turn <= 1; turn++) {
            enter(8 * (r * columns + c) + (nearest + turn & 7));
          }
        }
      }
    }

    /** By the path to the first point of the lattice from which the rest is moves on it. */
    private void enter(int state) {
      Pose to = pose(state);
      Pose seen = start.relative(to);
      double angle = Angles.difference(start.theta(), to.theta());
      double leg = length(state & 7) - ROUNDING;
      if (Math.abs(angle) < PARALLEL) {
        boolean isAhead =
            Math.abs(seen.y()) < ROUNDING
                && Math.abs(angle) < ROUNDING
                && seen.x() > -ROUNDING
                && seen.x() < leg;
        if (isAhead) {
          enter(state, List.of(to.position()));
        } else if (Math.abs(seen.y()) < MAX_ASIDE
            && seen.x() > 4 * step
            && seen.x() < 4 * step + leg) {
          Vec2 bend = start.compose(new Pose(seen.x() / 2, 0, 0)).position();
          enter(state, List.of(bend, to.position()));
        }
        return;
      }
      // start + s forward = to - u heading
      double u = seen.y() / Math.sin(angle);
      double s = seen.x() - u * Math.cos(angle);
      double least = tangent(angle) - ROUNDING;
      if (s >= least && u >= least && u < least + leg) {
        enter(state, List.of(start.compose(new Pose(s, 0, 0)).position(), to.position()));
      }
    }

    private void enter(int state, List<Vec2> entry) {
      double length = 0;
      Vec2 from = start.position();
      for (Vec2 to : entry) {
        length += from.distanceTo(to);
        from = to;
      }
      if (length < LONGEST_ENTRY && length < lengths[state] && isOpen(state) && isOpen(entry)) {
        reach(state, -1, length);
        entries.put(state, entry);
      }
    }

    private boolean isOpen(List<Vec2> entry) {
      Pose pose = start;
      for (Segment segment : arcs.fit(start, bends(entry)).segments()) {
        if (formation.sweptCells(grid, pose, segment).intersects(blocked)) {
          return false;
        }
        pose = pose.advanced(segment.twist(), segment.t());
      }
      return true;
    }

    private List<Waypoint> waypointsTo(int goalState) {
      List<Vec2> points = new ArrayList<>();
      int state = goalState;
      while (parents[state] >= 0) {
        int previous = parents[state];
        points.add(pose(state).position());
        if ((previous & 7) != (state & 7)) {
          int back = legs(previous & 7);
          points.add(
              pose(previous).compose(new Pose(back * length(previous & 7), 0, 0)).position());
        }
        state = previous;
      }
      points.addAll(entries.getOrDefault(state, List.of()).reversed());
      return bends(points.reversed());
    }

    /** Without the points that lie on a straight. */
    private List<Waypoint> bends(List<Vec2> points) {
      List<Waypoint> waypoints = new ArrayList<>();
      Vec2 from = start.position();
      for (int i = 0; i < points.size(); i++) {
        Vec2 here = points.get(i);
        boolean isLast = i == points.size() - 1;
        boolean isStraight = !isLast && here.distanceToLine(from, points.get(i + 1)) < ROUNDING;
        if (here.distanceTo(from) > ROUNDING && !isStraight) {
          waypoints.add(new Waypoint(here, false));
          from = here;
        }
      }
      return waypoints;
    }
  }
}
