package org.toqa.traffic.floor;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.DubinsCurve;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.planning.OpenList;
import org.toqa.planning.SearchLimit;

/**
 * Looks for the path that a formation can be led along: A* for the leader over the points of a
 * lattice and eight headings, by {@link FormationMoves}. From beside the lattice a curve leads onto
 * it.
 *
 * <p>The cost is that of a search over eight states a point. One object is for one search.
 */
final class FormationSearch {
  /** The curve onto the lattice is no longer, metres. */
  private static final double LONGEST_ENTRY = 1.2;

  /** Radians that it turns in all. */
  private static final double SHARPEST_ENTRY = 0.75 * Math.PI;

  /** Metres; no curve onto the lattice ends farther from the start. */
  private static final double NEAR_START = LONGEST_ENTRY * Math.sqrt(2);

  /** After so many states it is first looked at whether few lead to the goal. */
  private static final int FEW_STATES = 500;

  /** So many times as many are looked at, from both ends, before that is asked again. */
  private static final int MORE_STATES = 4;

  /** Of its arcs, in smallest radii: the wider, the less the followers swing out. */
  private static final int[] ENTRY_RADII = {1, 2, 4};

  /** So many curvatures to each side are tried to a goal that is near. */
  private static final int ARCS_TO_GOAL = 8;

  /** Metres; the goal is met in a circle several times as wide. */
  private static final double STEP_TO_GOAL = 0.02;

  private static final double ROUNDING = FormationLattice.ROUNDING;

  private final OccupancyGrid grid;
  private final FormationLattice lattice;
  private final Shape shape;
  private final FormationClearance clearance;
  private final Pose start;
  private final Vec2 goal;
  private final DriveSpeeds speeds;
  private final double radius;
  private final double[] lengths;
  private final int[] parents;
  private final FormationMoves moves;
  private final Map<Integer, DubinsCurve> entries = new HashMap<>();
  private BitSet dead = new BitSet();
  private final OpenList openList = new OpenList();

  /** States that have been reached and not expanded since. */
  private final BitSet reached = new BitSet();

  /**
   * @param start of the leader, map frame
   * @param goal where the load is carried, metres, map frame
   * @param speeds at which the leader drives
   */
  FormationSearch(
      OccupancyGrid grid,
      Shape shape,
      FormationClearance clearance,
      Pose start,
      Vec2 goal,
      DriveSpeeds speeds) {
    this.grid = grid;
    this.lattice = FormationLattice.of(grid);
    this.shape = shape;
    this.clearance = clearance;
    this.start = start;
    this.goal = goal;
    this.speeds = speeds;
    this.radius = shape.smallestRadius();
    this.lengths = new double[lattice.stateCount()];
    this.parents = new int[lengths.length];
    this.moves = new FormationMoves(lattice, shape, clearance, grid.rules());
    Arrays.fill(lengths, Double.POSITIVE_INFINITY);
    Arrays.fill(parents, -1);
  }

  /**
   * The path, if there is one.
   *
   * @param dead states from where the same shape is known to have none; where this has none either,
   *     what it reached is added
   */
  Optional<Trajectory> trajectory(BitSet dead) {
    this.dead = dead;
    enter();
    int expanded = 0;
    int next = FEW_STATES;
    while (!openList.isEmpty()) {
      SearchLimit.check();
      int state = openList.pop();
      if (!reached.get(state)) {
        continue;
      }
      reached.clear(state);
      if (++expanded == next) {
        if (isGoalClosed(next)) {
          break;
        }
        next *= MORE_STATES;
      }
      if (isGoal(lattice.pose(state))) {
        return Optional.of(trajectoryTo(state));
      }
      moves.forEachFrom(state, (end, length) -> reach(end, state, lengths[state] + length));
    }
    addReachedTo(dead);
    return arcToGoal();
  }

  private void addReachedTo(BitSet states) {
    for (int state = 0; state < lengths.length; state++) {
      if (lengths[state] < Double.POSITIVE_INFINITY) {
        states.set(state);
      }
    }
  }

  /**
   * Whether few states lead to the goal, and the start is far from all of them: then there is no
   * need to look at the whole floor.
   *
   * @param few states, at most
   */
  private boolean isGoalClosed(int few) {
    BitSet seen = new BitSet();
    Deque<Integer> next = new ArrayDeque<>();
    lattice.forEachPointAround(
        goal,
        shape.leader().norm() + FormationLattice.goalTolerance(grid),
        (column, row) -> {
          for (int heading = 0; heading < 8; heading++) {
            int state = lattice.state(column, row, heading);
            if (isGoal(lattice.pose(state)) && moves.isOpen(state)) {
              seen.set(state);
              next.add(state);
            }
          }
        });
    int count = 0;
    while (!next.isEmpty()) {
      int state = next.remove();
      Vec2 point = lattice.pose(state).position();
      if (++count > few || point.distanceTo(start.position()) < NEAR_START) {
        return false;
      }
      moves.forEachInto(
          state,
          (before, length) -> {
            if (!seen.get(before)) {
              seen.set(before);
              next.add(before);
            }
          });
    }
    return true;
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
          if (isGoal(trajectory.end()) && isOpen(trajectory)) {
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

  private void reach(int state, int from, double length) {
    if (length < lengths[state] - ROUNDING && !dead.get(state)) {
      lengths[state] = length;
      parents[state] = from;
      reached.set(state);
      openList.push(state, length + metresToGoal(lattice.pose(state)));
    }
  }

  /** Where it is if that is on the lattice, else all over the lattice round it. */
  private void enter() {
    int there = lattice.stateAt(start);
    if (there >= 0 && moves.isOpen(there)) {
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
    if (!moves.isOpen(state)) {
      return;
    }
    for (int radii : ENTRY_RADII) {
      for (DubinsCurve curve : DubinsCurve.between(start, lattice.pose(state), radii * radius)) {
        double length = curve.length();
        if (length < LONGEST_ENTRY
            && curve.turning() < SHARPEST_ENTRY
            && length < lengths[state]
            && isOpen(new Trajectory(start, curve.segments(speeds)))) {
          reach(state, -1, length);
          entries.put(state, curve);
        }
      }
    }
  }

  /** Whether it can be led along a curve from where it stands. */
  private boolean isOpen(Trajectory entry) {
    return clearance.isKeptOnEntry(entry)
        && DirectionCheck.isKept(
            grid.rules(),
            leader -> shape.loadAt(leader).position(),
            entry.start(),
            entry.segments());
  }

  private Trajectory trajectoryTo(int goalState) {
    List<Integer> states = new ArrayList<>();
    for (int state = goalState; state >= 0; state = parents[state]) {
      states.addFirst(state);
    }
    List<Segment> segments = new ArrayList<>();
    DubinsCurve entry = entries.get(states.getFirst());
    if (entry != null) {
      segments.addAll(entry.segments(speeds));
    }
    double straight = 0; // metres
    for (int i = 1; i < states.size(); i++) {
      int heading = states.get(i - 1) & 7;
      int eighths = (states.get(i) - heading + 12 & 7) - 4;
      if (eighths == 0) {
        straight += lattice.length(heading);
      } else {
        List<Twist> corner = moves.corner(heading, eighths);
        addStraight(segments, straight + corner.getFirst().vx());
        segments.add(arc(corner.get(1)));
        straight = corner.getLast().vx();
      }
    }
    addStraight(segments, straight);
    return new Trajectory(start, segments);
  }

  private void addStraight(List<Segment> segments, double length) {
    if (length > ROUNDING) {
      segments.add(new Segment(speeds.forward(), 0, length / speeds.forward()));
    }
  }

  private Segment arc(Twist piece) {
    double rate = Math.min(speeds.forward() / radius, speeds.arcRate());
    double seconds = Math.abs(piece.w()) / rate;
    return new Segment(radius * rate, Math.copySign(rate, piece.w()), seconds);
  }
}
