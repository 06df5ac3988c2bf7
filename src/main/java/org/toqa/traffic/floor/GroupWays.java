package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import org.toqa.formation.WayRules;
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

/**
 * Ways that a group can be led along: A* for the leader over the points of a lattice and eight
 * headings. A move is a step along the heading, or a corner of 45 degrees with as much of a leg
 * before and behind it as an arc of the smallest radius needs, so that no way has a tighter one; it
 * is open where the whole group, with a margin, meets nothing on it. The first leg leads from where
 * the leader faces onto the lattice.
 *
 * <p>The cost is that of a search over eight states a point. Confined to one thread.
 */
final class GroupWays {
  /** Kept from walls while a way is looked for, metres. */
  private static final double MARGIN = 0.02;

  /** Lattice points are at most so far apart, metres. */
  private static final double WIDEST_STEP = 0.15;

  /** The way onto the lattice is no longer, metres. */
  private static final double LONGEST_ENTRY = 1.5;

  /** So far beside the lattice, metres, a parallel way onto it may begin. */
  private static final double LARGEST_ASIDE = 0.06;

  /** A robot that has come to its place stands no farther from it, metres. */
  private static final double OFF_PLACE = 0.01;

  /** Radians. */
  private static final double OFF_HEADING = 0.02;

  /** Radians; below it two directions are parallel. */
  private static final double PARALLEL = 0.01;

  private static final double ROUNDING = 1e-6;
  private static final Heading[] HEADINGS = Heading.values();
  private static final double EIGHTH = Math.PI / 4;

  /** Stretches end at least so far apart, metres. */
  private static final double HALTS_EVERY = 0.3;

  private final OccupancyGrid grid;
  private final CourseFitter fitter;
  private final double step;
  private final Vec2 first;
  private final int columns;
  private final int rows;

  GroupWays(OccupancyGrid grid, CourseFitter fitter) {
    this.grid = grid;
    this.fitter = fitter;
    double cell = grid.resolution();
    this.step = step(grid);
    this.first = first(grid);
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
  private static Vec2 first(OccupancyGrid grid) {
    double cell = grid.resolution();
    return grid.origin().plus(new Vec2(cell / 2, cell / 2));
  }

  /**
   * Where the way of a group begins whose leader stands there: on the lattice if it is but for what
   * a robot may be off its place. It is drawn onto its way as it sets out; a way that began beside
   * the lattice would need room to get onto it, which a place between machines has not.
   */
  static Pose start(OccupancyGrid grid, Pose leader) {
    double step = step(grid);
    Vec2 first = first(grid);
    Pose onLattice =
        new Pose(
            first.x() + Math.rint((leader.x() - first.x()) / step) * step,
            first.y() + Math.rint((leader.y() - first.y()) / step) * step,
            Heading.nearest(leader.theta()).ordinal() * EIGHTH);
    return isAt(onLattice, leader) ? onLattice : leader;
  }

  /** Whether who was sent to a place has come there. */
  static boolean isAt(Pose place, Pose stands) {
    return place.distanceTo(stands) < OFF_PLACE
        && Math.abs(Angles.difference(stands.theta(), place.theta())) < OFF_HEADING;
  }

  /** Metres that the load may stand beside its goal. */
  static double nearness(OccupancyGrid grid) {
    return Math.min(WIDEST_STEP, Math.max(grid.resolution(), WIDEST_STEP / 2)) * 0.8;
  }

  /**
   * The shortest way on which the group meets none of these cells.
   *
   * @param goal where the load is carried, metres, map frame
   */
  Optional<List<Stretch>> way(Mover m, Group group, Vec2 goal, BitSet closed) {
    Pose start = m.releasedEnd();
    WayRules rules = new WayRules(group.shape(), m.speeds.forward());
    SegmentFitter arcs = new SegmentFitter(m.speeds, rules.cornerLength(EIGHTH));
    return new Search(group, start, goal, closed, arcs)
        .way()
        .map(way -> rules.slowed(arcs.fit(start, way)))
        .filter(way -> rules.breach(way).isEmpty())
        .map(way -> stretches(m, way))
        .filter(way -> !way.isEmpty() && way.stream().noneMatch(s -> s.cells().intersects(closed)));
  }

  private List<Stretch> stretches(Mover m, Trajectory way) {
    return fitter.cut(m, way, new Halts.Spaced(Math.max(HALTS_EVERY, grid.resolution())));
  }

  /** One search; a state is {@code 8 (row columns + column) + heading}. */
  private final class Search {
    private final Group group;
    private final Pose start;
    private final Vec2 goal;
    private final BitSet closed;
    private final SegmentFitter arcs;
    private final double radius;
    private final double[] lengths = new double[HEADINGS.length * columns * rows];
    private final int[] before = new int[lengths.length];
    private final byte[] open = new byte[lengths.length];
    private final Map<Integer, List<Vec2>> entries = new HashMap<>();
    private final PriorityQueue<Reached> queue =
        new PriorityQueue<>(Comparator.comparingDouble(Reached::estimate));

    private record Reached(int state, double length, double estimate) {}

    Search(Group group, Pose start, Vec2 goal, BitSet closed, SegmentFitter arcs) {
      this.group = group;
      this.start = start;
      this.goal = goal;
      this.closed = closed;
      this.arcs = arcs;
      this.radius = group.shape().smallestRadius();
      Arrays.fill(lengths, Double.POSITIVE_INFINITY);
      Arrays.fill(before, -1);
    }

    /** Where the way bends and ends. */
    Optional<List<Waypoint>> way() {
      enter();
      while (!queue.isEmpty()) {
        Reached reached = queue.poll();
        int state = reached.state();
        if (reached.length() > lengths[state]) {
          continue;
        }
        if (isGoal(state)) {
          return Optional.of(wayTo(state));
        }
        expand(state);
      }
      return Optional.empty();
    }

    private boolean isGoal(int state) {
      return group.shape().loadAt(pose(state)).position().distanceTo(goal) < nearness(grid);
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
        if (!group.isOff(grid, pose, MARGIN, closed)) {
          return false;
        }
      }
      return true;
    }

    private void reach(int state, int from, double length) {
      if (length < lengths[state] - ROUNDING) {
        lengths[state] = length;
        before[state] = from;
        if (from >= 0) {
          entries.remove(state);
        }
        double rest = group.shape().loadAt(pose(state)).position().distanceTo(goal);
        queue.add(new Reached(state, length, length + rest));
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
        open[state] = (byte) (group.isOff(grid, pose(state), MARGIN, closed) ? 1 : 2);
      }
      return open[state] == 1;
    }

    private Pose pose(int state) {
      int point = state >> 3;
      int column = point % columns;
      int row = point / columns;
      return new Pose(first.x() + column * step, first.y() + row * step, (state & 7) * EIGHTH);
    }

    /** The ways onto the lattice: straight ahead, one corner, and straight again. */
    private void enter() {
      int reach = (int) Math.ceil(LONGEST_ENTRY / step);
      int column = (int) Math.round((start.x() - first.x()) / step);
      int row = (int) Math.round((start.y() - first.y()) / step);
      int nearest = Heading.nearest(start.theta()).ordinal();
      for (int r = Math.max(0, row - reach); r <= Math.min(rows - 1, row + reach); r++) {
        for (int c = Math.max(0, column - reach); c <= Math.min(columns - 1, column + reach); c++) {
          for (int turn = -1; turn <= 1; turn++) {
            enter(8 * (r * columns + c) + (nearest + turn & 7));
          }
        }
      }
    }

    /** By the way to the first point of the lattice from which the rest is moves on it. */
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
        } else if (Math.abs(seen.y()) < LARGEST_ASIDE
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

    private void enter(int state, List<Vec2> way) {
      double length = 0;
      Vec2 from = start.position();
      for (Vec2 to : way) {
        length += from.distanceTo(to);
        from = to;
      }
      if (length < LONGEST_ENTRY && length < lengths[state] && isOpen(state) && isOpen(way)) {
        reach(state, -1, length);
        entries.put(state, way);
      }
    }

    private boolean isOpen(List<Vec2> entry) {
      Pose pose = start;
      for (Segment segment : arcs.fit(start, bends(entry)).segments()) {
        if (group.swept(grid, pose, segment).intersects(closed)) {
          return false;
        }
        pose = pose.advanced(segment.twist(), segment.t());
      }
      return true;
    }

    private List<Waypoint> wayTo(int goalState) {
      List<Vec2> points = new ArrayList<>();
      int state = goalState;
      while (before[state] >= 0) {
        int previous = before[state];
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
      List<Waypoint> way = new ArrayList<>();
      Vec2 from = start.position();
      for (int i = 0; i < points.size(); i++) {
        Vec2 here = points.get(i);
        boolean isLast = i == points.size() - 1;
        boolean isStraight = !isLast && here.distanceToLine(from, points.get(i + 1)) < ROUNDING;
        if (here.distanceTo(from) > ROUNDING && !isStraight) {
          way.add(new Waypoint(here, false));
          from = here;
        }
      }
      return way;
    }
  }
}
