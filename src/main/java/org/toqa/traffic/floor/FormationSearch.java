package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.SegmentFitter;
import org.toqa.planning.Heading;
import org.toqa.planning.OpenList;

/**
 * Looks for the path that a formation can be led along: A* for the leader over the points of a
 * lattice and eight headings. A move is a step along the heading, or a corner of 45 degrees with as
 * much of a leg before and behind it as an arc of the smallest radius needs, so that no path has a
 * tighter one; it is open where the whole formation, with a margin, meets nothing on it. The first
 * leg leads from where the leader faces onto the lattice.
 *
 * <p>The cost is that of a search over eight states a point. One object is for one search.
 */
final class FormationSearch {
  /** Kept from walls while a path is looked for, metres. */
  private static final double MARGIN = 0.02;

  /** The path onto the lattice is no longer, metres. */
  private static final double LONGEST_ENTRY = 1.5;

  /** So far beside the lattice, metres, a parallel path onto it may begin. */
  private static final double MAX_ASIDE = 0.06;

  /** Radians; below it two directions are parallel. */
  private static final double PARALLEL = 0.01;

  private static final double ROUNDING = FormationLattice.ROUNDING;
  private static final double EIGHTH = FormationLattice.EIGHTH;

  private final OccupancyGrid grid;
  private final FormationLattice lattice;
  private final FormationFootprint formation;
  private final Pose start;
  private final Vec2 goal;
  private final BitSet blocked;
  private final SegmentFitter arcs;
  private final double radius;
  private final double[] lengths;
  private final int[] parents;
  private final byte[] open;
  private final Map<Integer, List<Vec2>> entries = new HashMap<>();
  private final OpenList openList = new OpenList();

  /** States that have been reached and not expanded since. */
  private final BitSet reached = new BitSet();

  /**
   * @param start of the leader, map frame
   * @param goal where the load is carried, metres, map frame
   * @param blocked cells that the formation may not meet
   * @param arcs fits the path's corners
   */
  FormationSearch(
      OccupancyGrid grid,
      FormationFootprint formation,
      Pose start,
      Vec2 goal,
      BitSet blocked,
      SegmentFitter arcs) {
    this.grid = grid;
    this.lattice = FormationLattice.of(grid);
    this.formation = formation;
    this.start = start;
    this.goal = goal;
    this.blocked = blocked;
    this.arcs = arcs;
    this.radius = formation.shape().smallestRadius();
    this.lengths = new double[lattice.stateCount()];
    this.parents = new int[lengths.length];
    this.open = new byte[lengths.length];
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
    return metresToGoal(state) < FormationLattice.goalTolerance(grid);
  }

  private double metresToGoal(int state) {
    return formation.shape().loadAt(lattice.pose(state)).position().distanceTo(goal);
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
    return (int) Math.ceil(tangent(EIGHTH) / lattice.length(heading) - ROUNDING);
  }

  // t = R tan(angle/2)
  private double tangent(double angle) {
    return radius * Math.tan(Math.abs(angle) / 2);
  }

  /** Steps along one heading, and then some along the next. */
  private void advance(int state, int heading, int count, int then, int countThen) {
    int at = state;
    for (int i = 1; i <= count; i++) {
      at = lattice.neighbour(at, heading);
      boolean isInArc = countThen > 0 && i == count;
      if (at < 0 || (!isInArc && !isOpen(at))) {
        return;
      }
    }
    for (int i = 1; i <= countThen; i++) {
      at = lattice.neighbour((at & ~7) | then, then);
      if (at < 0 || !isOpen(at)) {
        return;
      }
    }
    if (countThen > 0 && !isArcOpen(state, heading, count, then)) {
      return;
    }
    double length =
        lengths[state] + count * lattice.length(heading) + countThen * lattice.length(then);
    reach(at, state, length);
  }

  private boolean isArcOpen(int state, int heading, int count, int then) {
    double tangent = tangent(EIGHTH);
    double before = count * lattice.length(heading) - tangent;
    Pose pose = lattice.pose(state).compose(new Pose(before, 0, 0));
    double turn = (then - heading + 12 & 7) == 5 ? EIGHTH : -EIGHTH;
    int pieces = Math.max(3, (int) Math.ceil(radius * EIGHTH / lattice.step()));
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
      reached.set(state);
      openList.push(state, length + metresToGoal(state));
    }
  }

  private boolean isOpen(int state) {
    if (open[state] == 0) {
      open[state] =
          (byte) (formation.isClearOf(grid, lattice.pose(state), MARGIN, blocked) ? 1 : 2);
    }
    return open[state] == 1;
  }

  /** The paths onto the lattice: straight ahead, one corner, and straight again. */
  private void enter() {
    int nearest = Heading.nearest(start.theta()).ordinal();
    lattice.forEachPointAround(
        start.position(),
        LONGEST_ENTRY,
        (column, row) -> {
          for (int turn = -1; turn <= 1; turn++) {
            enter(lattice.state(column, row, nearest + turn & 7));
          }
        });
  }

  /** By the path to the first point of the lattice from which the rest is moves on it. */
  private void enter(int state) {
    Pose to = lattice.pose(state);
    Pose seen = start.relative(to);
    double angle = Angles.difference(start.theta(), to.theta());
    double leg = lattice.length(state & 7) - ROUNDING;
    if (Math.abs(angle) < PARALLEL) {
      boolean isAhead =
          Math.abs(seen.y()) < ROUNDING
              && Math.abs(angle) < ROUNDING
              && seen.x() > -ROUNDING
              && seen.x() < leg;
      if (isAhead) {
        enter(state, List.of(to.position()));
      } else if (Math.abs(seen.y()) < MAX_ASIDE
          && seen.x() > 4 * lattice.step()
          && seen.x() < 4 * lattice.step() + leg) {
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
      points.add(lattice.pose(state).position());
      if ((previous & 7) != (state & 7)) {
        int back = legs(previous & 7);
        points.add(
            lattice
                .pose(previous)
                .compose(new Pose(back * lattice.length(previous & 7), 0, 0))
                .position());
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
