package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.DubinsCurve;
import org.toqa.motion.Segment;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;
import org.toqa.planning.OpenList;
import org.toqa.planning.SearchLimit;

/**
 * Looks for the path that a formation can be led along: A* for the leader over the points of a
 * lattice and eight headings. A move is a step along the heading, or a corner of 45 degrees with as
 * much of a leg before and behind it as an arc of the smallest radius needs, so that no path has a
 * tighter one; it is open where the whole formation, with a margin, meets nothing on it. From
 * beside the lattice a curve leads onto it.
 *
 * <p>The cost is that of a search over eight states a point. One object is for one search.
 */
final class FormationSearch {
  /** The curve onto the lattice is no longer, metres. */
  private static final double LONGEST_ENTRY = 1.2;

  /** Radians that it turns in all. */
  private static final double SHARPEST_ENTRY = 0.75 * Math.PI;

  /** Of its arcs, in smallest radii: the wider, the less the followers swing out. */
  private static final int[] ENTRY_RADII = {1, 2, 4};

  /** So many curvatures to each side are tried to a goal that is near. */
  private static final int ARCS_TO_GOAL = 8;

  /** Metres; the goal is met in a circle several times as wide. */
  private static final double STEP_TO_GOAL = 0.02;

  private static final double ROUNDING = FormationLattice.ROUNDING;
  private static final double EIGHTH = FormationLattice.EIGHTH;

  private final OccupancyGrid grid;
  private final FormationLattice lattice;
  private final Shape shape;
  private final FormationClearance clearance;
  private final Pose start;
  private final Vec2 goal;
  private final DriveSpeeds speeds;
  private final SegmentFitter arcs;
  private final double radius;
  private final double[] lengths;
  private final int[] parents;
  private final byte[] open;
  private final byte[] openSteps;

  /** Metres. */
  private final double spacing;

  private final Map<Integer, DubinsCurve> entries = new HashMap<>();
  private final OpenList openList = new OpenList();

  /** States that have been reached and not expanded since. */
  private final BitSet reached = new BitSet();

  /**
   * @param start of the leader, map frame
   * @param goal where the load is carried, metres, map frame
   * @param speeds at which the leader drives
   * @param arcs fits the path's corners
   */
  FormationSearch(
      OccupancyGrid grid,
      Shape shape,
      FormationClearance clearance,
      Pose start,
      Vec2 goal,
      DriveSpeeds speeds,
      SegmentFitter arcs) {
    this.grid = grid;
    this.lattice = FormationLattice.of(grid);
    this.shape = shape;
    this.clearance = clearance;
    this.start = start;
    this.goal = goal;
    this.speeds = speeds;
    this.arcs = arcs;
    this.radius = shape.smallestRadius();
    this.lengths = new double[lattice.stateCount()];
    this.parents = new int[lengths.length];
    this.open = new byte[lengths.length];
    this.openSteps = new byte[lengths.length];
    this.spacing = clearance.spacing();
    Arrays.fill(lengths, Double.POSITIVE_INFINITY);
    Arrays.fill(parents, -1);
  }

  /** The path, if there is one. */
  Optional<Trajectory> trajectory() {
    enter();
    while (!openList.isEmpty()) {
      SearchLimit.check();
      int state = openList.pop();
      if (!reached.get(state)) {
        continue;
      }
      reached.clear(state);
      if (isGoal(lattice.pose(state))) {
        return Optional.of(trajectoryTo(state));
      }
      expand(state);
    }
    return arcToGoal();
  }

  /** One arc, to a goal so near that there is no room to get onto the lattice before it. */
  private Optional<Trajectory> arcToGoal() {
    for (int i = 0; i <= ARCS_TO_GOAL; i++) {
      for (int side = -1; side <= 1; side += 2) {
        double curvature = side * i / (ARCS_TO_GOAL * radius);
        for (double length = STEP_TO_GOAL; length < LONGEST_ENTRY; length += STEP_TO_GOAL) {
          double v = Math.min(speeds.forward(), speeds.arcRate() / Math.abs(curvature));
          Segment arc = new Segment(v, v * curvature, length / v);
          Trajectory trajectory = new Trajectory(start, List.of(arc));
          if (isGoal(trajectory.end()) && clearance.isKeptOnEntry(trajectory)) {
            return Optional.of(trajectory);
          }
        }
      }
    }
    return Optional.empty();
  }

  private boolean isGoal(Pose leader) {
    return metresToGoal(leader) < FormationLattice.goalTolerance(grid);
  }

  private double metresToGoal(Pose leader) {
    return shape.loadAt(leader).position().distanceTo(goal);
  }

  private void expand(int state) {
    int heading = state & 7;
    int ahead = lattice.neighbour(state, heading);
    if (ahead >= 0 && isStepOpen(state)) {
      reach(ahead, state, lengths[state] + lattice.length(heading));
    }
    for (int turn = -1; turn <= 1; turn += 2) {
      turn(state, heading, heading + turn & 7);
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

  /** Steps along one heading, a corner, and steps along the next. */
  private void turn(int state, int heading, int next) {
    int end = ahead(ahead(state, heading), next);
    if (end < 0 || !isOpen(end)) {
      return;
    }
    double before = legs(heading) * lattice.length(heading);
    double after = legs(next) * lattice.length(next);
    double angle = (next - heading + 12 & 7) == 5 ? EIGHTH : -EIGHTH;
    double tangent = tangent(EIGHTH);
    Pose from = lattice.pose(state);
    Pose arc = from.compose(new Pose(before - tangent, 0, 0));
    Pose leg = arc.advanced(new Twist(radius * EIGHTH, 0, angle), 1);
    if (isOpenAlong(from, before - tangent, 0)
        && isOpenAlong(arc, radius * EIGHTH, angle)
        && isOpenAlong(leg, after - tangent, 0)) {
      reach(end, state, lengths[state] + before + after);
    }
  }

  /** The legs of a corner on from a state, in a heading; -1: outside. */
  private int ahead(int state, int heading) {
    int at = state < 0 ? state : (state & ~7) | heading;
    for (int i = legs(heading); i > 0 && at >= 0; i--) {
      at = lattice.neighbour(at, heading);
    }
    return at;
  }

  /** Whether the leader can be led from there so many metres, round so many radians. */
  private boolean isOpenAlong(Pose from, double length, double angle) {
    double farthest = length + Math.abs(angle) * shape.reach(); // that any robot drives
    int pieces = Math.max(1, (int) Math.ceil(farthest / spacing));
    Twist piece = new Twist(length / pieces, 0, angle / pieces);
    Pose pose = from;
    for (int i = 0; i < pieces; i++) {
      pose = pose.advanced(piece, 1);
      if (!clearance.isKeptAt(pose)) {
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
      openList.push(state, length + metresToGoal(lattice.pose(state)));
    }
  }

  private boolean isOpen(int state) {
    if (open[state] == 0) {
      open[state] = (byte) (clearance.isKeptAt(lattice.pose(state)) ? 1 : 2);
    }
    return open[state] == 1;
  }

  private boolean isStepOpen(int state) {
    if (openSteps[state] == 0) {
      boolean isOpen = isOpenAlong(lattice.pose(state), lattice.length(state & 7), 0);
      openSteps[state] = (byte) (isOpen ? 1 : 2);
    }
    return openSteps[state] == 1;
  }

  /** Where it is if that is on the lattice, else all over the lattice round it. */
  private void enter() {
    int there = lattice.stateAt(start);
    if (there >= 0 && isOpen(there)) {
      reach(there, -1, 0);
      return;
    }
    lattice.forEachPointAround(
        start.position(),
        LONGEST_ENTRY,
        (column, row) -> {
          for (int heading = 0; heading < 8; heading++) {
            enter(lattice.state(column, row, heading));
          }
        });
  }

  private void enter(int state) {
    if (!isOpen(state)) {
      return;
    }
    for (int radii : ENTRY_RADII) {
      for (DubinsCurve curve : DubinsCurve.between(start, lattice.pose(state), radii * radius)) {
        double length = curve.length();
        if (length < LONGEST_ENTRY
            && curve.turning() < SHARPEST_ENTRY
            && length < lengths[state]
            && clearance.isKeptOnEntry(new Trajectory(start, curve.segments(speeds)))) {
          reach(state, -1, length);
          entries.put(state, curve);
        }
      }
    }
  }

  private Trajectory trajectoryTo(int goalState) {
    List<Segment> segments = new ArrayList<>();
    List<Waypoint> waypoints = new ArrayList<>();
    int first = waypointsTo(goalState, waypoints);
    DubinsCurve entry = entries.get(first);
    if (entry != null) {
      segments.addAll(entry.segments(speeds));
    }
    segments.addAll(arcs.fit(lattice.pose(first), waypoints).segments());
    return new Trajectory(start, segments);
  }

  /**
   * @param waypoints where the bends and the end are added
   * @return the state where the path is on the lattice
   */
  private int waypointsTo(int goalState, List<Waypoint> waypoints) {
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
    waypoints.addAll(bends(lattice.pose(state).position(), points.reversed()));
    return state;
  }

  /** Without the points that lie on a straight. */
  private static List<Waypoint> bends(Vec2 start, List<Vec2> points) {
    List<Waypoint> waypoints = new ArrayList<>();
    Vec2 from = start;
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
