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
import org.toqa.geometry.Angles;
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
 * it. Where it may be led sideways too, shifts cost more than a long way round: sensors look
 * forward.
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

  /** Radians that a group has come to stand askew, at most, which it corrects on a short arc. */
  private static final double MOST_ASKEW = 0.1;

  /** Metres a second to the side, where no sensor looks. */
  private static final double SHIFT_SPEED = 0.1;

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
  private final boolean shifting;
  private final Map<Integer, List<Segment>> entries = new HashMap<>();
  private BitSet dead = new BitSet();
  private final OpenList openList = new OpenList();

  /** States that have been reached and not expanded since. */
  private final BitSet reached = new BitSet();

  /**
   * @param start of the leader, map frame
   * @param goal where the load is carried, metres, map frame
   * @param speeds at which the leader drives
   * @param shifting whether it may be led sideways
   */
  FormationSearch(
      OccupancyGrid grid,
      Shape shape,
      FormationClearance clearance,
      Pose start,
      Vec2 goal,
      DriveSpeeds speeds,
      boolean shifting) {
    this.grid = grid;
    this.lattice = FormationLattice.of(grid);
    this.shape = shape;
    this.clearance = clearance;
    this.start = start;
    this.goal = goal;
    this.speeds = speeds;
    this.shifting = shifting;
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
      if (shifting) {
        moves.forEachShiftFrom(state, (end, cost) -> reach(end, state, lengths[state] + cost));
      }
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
      FormationMoves.MoveVisitor visitor =
          (before, length) -> {
            if (!seen.get(before)) {
              seen.set(before);
              next.add(before);
            }
          };
      moves.forEachInto(state, visitor);
      if (shifting) {
        moves.forEachShiftInto(state, visitor);
      }
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
          entries.put(state, curve.segments(speeds));
        }
      }
    }
    if (shifting) {
      enterByShift(state);
    }
  }

  /** Straight on and to the side, or the other way round; first it turns as it shall face. */
  private void enterByShift(int state) {
    double askew = Angles.difference(start.theta(), lattice.pose(state).theta());
    if (Math.abs(askew) > MOST_ASKEW) {
      return;
    }
    List<Segment> turn =
        Math.abs(askew) > ROUNDING
            ? List.of(arc(new Twist(radius * Math.abs(askew), 0, askew)))
            : List.of();
    Pose there = new Trajectory(start, turn).end().relative(lattice.pose(state));
    double length = radius * Math.abs(askew) + there.x() + FormationMoves.shiftCost(there.y());
    if (Math.abs(there.y()) > LONGEST_ENTRY
        || there.x() < -ROUNDING
        || there.x() > LONGEST_ENTRY
        || length >= lengths[state]) {
      return;
    }
    List<Segment> ahead = new ArrayList<>();
    addStraight(ahead, there.x());
    List<Segment> aside = new ArrayList<>();
    addShift(aside, there.y());
    for (List<List<Segment>> order :
        List.of(List.of(turn, ahead, aside), List.of(turn, aside, ahead))) {
      List<Segment> entry = order.stream().flatMap(List::stream).toList();
      if (!entry.isEmpty() && isOpenWithShift(entry)) {
        reach(state, -1, length);
        entries.put(state, entry);
        return;
      }
    }
  }

  /** Whether it can be led so, with what a shift keeps clear before it if it is no correction. */
  private boolean isOpenWithShift(List<Segment> entry) {
    Trajectory trajectory = new Trajectory(start, entry);
    for (int i = 0; i < entry.size(); i++) {
      Segment segment = entry.get(i);
      if (segment.shifts() && segment.length() > Trajectory.MAX_DEVIATION) {
        double more = FormationMoves.SHIFT_MARGIN / segment.speed();
        Segment longer = segment.lasting(segment.t() + more);
        if (!clearance.isKeptOnEntry(new Trajectory(trajectory.poseAfter(i), List.of(longer)))) {
          return false;
        }
      }
    }
    return isOpen(trajectory);
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
    segments.addAll(entries.getOrDefault(states.getFirst(), List.of()));
    double straight = 0; // metres
    double shift = 0; // metres to the left
    for (int i = 1; i < states.size(); i++) {
      int heading = states.get(i - 1) & 7;
      int eighths = (states.get(i) - heading + 12 & 7) - 4;
      double aside = eighths == 0 ? shiftBetween(states.get(i - 1), states.get(i)) : 0;
      if (aside == 0 || aside * shift < 0) {
        addShift(segments, shift);
        shift = 0;
      }
      if (aside != 0) {
        addStraight(segments, straight);
        straight = 0;
        shift += aside;
      } else if (eighths == 0) {
        straight += lattice.length(heading);
      } else {
        List<Twist> corner = moves.corner(heading, eighths);
        addStraight(segments, straight + corner.getFirst().vx());
        segments.add(arc(corner.get(1)));
        straight = corner.getLast().vx();
      }
    }
    addStraight(segments, straight);
    addShift(segments, shift);
    return new Trajectory(start, segments);
  }

  /** Metres to the left from one state to another of the same heading; 0: straight on. */
  private double shiftBetween(int from, int to) {
    double aside = lattice.pose(from).relative(lattice.pose(to)).y();
    return Math.abs(aside) < ROUNDING ? 0 : aside;
  }

  private void addShift(List<Segment> segments, double metresLeft) {
    if (Math.abs(metresLeft) > ROUNDING) {
      double speed = Math.min(SHIFT_SPEED, speeds.forward());
      segments.add(Segment.shift(Math.copySign(speed, metresLeft), Math.abs(metresLeft) / speed));
    }
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
