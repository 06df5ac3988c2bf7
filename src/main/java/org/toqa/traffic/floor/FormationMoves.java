package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.grid.MoveRules;
import org.toqa.motion.Segment;

/**
 * How a formation can be led over its lattice: a move is a step along the heading, or a corner of
 * 45 or 90 degrees with as much of a leg before and behind it as an arc of the smallest radius
 * needs, so that no path has a tighter one. A move is open where the whole formation, with a
 * margin, meets nothing on it, and the middle of its load keeps the directions of the floor. A
 * shift goes some steps to the side, with more room on that side. States are those of {@link
 * FormationLattice}.
 */
final class FormationMoves {
  /** In eighths of a full turn. */
  private static final int[] CORNERS = {-1, 1, -2, 2};

  /** Metres that are free on that side beyond where a shift ends: no sensor looks there. */
  static final double SHIFT_MARGIN = 0.05;

  /** What a shift costs besides its length, metres: the group stands before it and behind it. */
  private static final double SHIFT_START = 0.5;

  /** What each of its metres costs: it is slow. */
  private static final double SHIFT_COST = 2.5;

  /** Of one shift, so that one long shift is not many short ones. */
  private static final int MOST_SHIFT_STEPS = 8;

  private static final double ROUNDING = FormationLattice.ROUNDING;
  private static final double EIGHTH = FormationLattice.EIGHTH;

  private final FormationLattice lattice;
  private final Shape shape;
  private final FormationClearance clearance;
  private final MoveRules rules;
  private final double radius;

  /** Metres. */
  private final double spacing;

  private final byte[] open;
  private final byte[] openSteps;

  /** By state, two bits a corner. */
  private final byte[] openCorners;

  /** By state, two bits a side. */
  private final byte[] openShifts;

  /** By heading and side, right and left: where it is looked at. */
  private final FormationFootprint.Placement[][][] onShifts =
      new FormationFootprint.Placement[8][2][];

  /** By heading and eighths turned, the latter and 2: where it is looked at, from the state on. */
  private final FormationFootprint.Placement[][][] onMoves =
      new FormationFootprint.Placement[8][5][];

  FormationMoves(
      FormationLattice lattice, Shape shape, FormationClearance clearance, MoveRules rules) {
    this.rules = rules;
    this.lattice = lattice;
    this.shape = shape;
    this.clearance = clearance;
    this.radius = shape.smallestRadius();
    this.spacing = clearance.spacing();
    this.open = new byte[lattice.stateCount()];
    this.openSteps = new byte[open.length];
    this.openCorners = new byte[open.length];
    this.openShifts = new byte[open.length];
  }

  /** Is given moves, as the state at their other end and their length, metres. */
  interface MoveVisitor {
    void visit(int state, double length);
  }

  /** Visits the open moves from a state. */
  void forEachFrom(int state, MoveVisitor visitor) {
    int heading = state & 7;
    int ahead = lattice.neighbour(state, heading);
    if (ahead >= 0 && isStepOpen(state)) {
      visitor.visit(ahead, lattice.length(heading));
    }
    for (int corner = 0; corner < CORNERS.length; corner++) {
      int eighths = CORNERS[corner];
      int next = heading + eighths & 7;
      int end = along(along(state, heading, heading, eighths), next, next, eighths);
      if (end >= 0 && isCornerOpen(state, corner, end)) {
        visitor.visit(end, cornerLength(heading, eighths));
      }
    }
  }

  /** Visits the open moves that end in a state, which is open. */
  void forEachInto(int state, MoveVisitor visitor) {
    int heading = state & 7;
    int behind = back(lattice.neighbour(state, heading + 4 & 7), heading);
    if (behind >= 0 && isOpen(behind) && isStepOpen(behind)) {
      visitor.visit(behind, lattice.length(heading));
    }
    for (int corner = 0; corner < CORNERS.length; corner++) {
      int eighths = CORNERS[corner];
      int before = heading - eighths & 7;
      int middle = along(state, heading + 4 & 7, heading, eighths);
      int from = back(along(middle, before + 4 & 7, before, eighths), before);
      if (from >= 0 && isOpen(from) && isCornerOpen(from, corner, state)) {
        visitor.visit(from, cornerLength(before, eighths));
      }
    }
  }

  /** What a shift costs, in metres of driving forward; 0: none. */
  static double shiftCost(double metres) {
    return metres == 0 ? 0 : SHIFT_START + SHIFT_COST * Math.abs(metres);
  }

  /** Visits the open shifts from a state, with what they cost. */
  void forEachShiftFrom(int state, MoveVisitor visitor) {
    int heading = state & 7;
    for (int side = 0; side < 2; side++) {
      int direction = direction(heading, side);
      int at = state;
      for (int steps = 1; steps <= MOST_SHIFT_STEPS; steps++) {
        int next = back(lattice.neighbour(at, direction), heading);
        if (next < 0 || !isShiftOpen(at, side)) {
          break;
        }
        visitor.visit(next, shiftCost(steps * lattice.length(direction)));
        at = next;
      }
    }
  }

  /** Visits the open shifts of one step that end in a state, which is open. */
  void forEachShiftInto(int state, MoveVisitor visitor) {
    int heading = state & 7;
    for (int side = 0; side < 2; side++) {
      int direction = direction(heading, side);
      int before = back(lattice.neighbour(state, direction + 4 & 7), heading);
      if (before >= 0 && isOpen(before) && isShiftOpen(before, side)) {
        visitor.visit(before, shiftCost(lattice.length(direction)));
      }
    }
  }

  /**
   * @param side 0: to the right; 1: to the left
   */
  private static int direction(int heading, int side) {
    return heading + (side == 0 ? -2 : 2) & 7;
  }

  private boolean isShiftOpen(int state, int side) {
    int known = (openShifts[state] >> (2 * side)) & 3;
    if (known == 0) {
      known =
          isOpenOn(state, onShift(state & 7, side))
                  && keepsDirections(state, shift(state & 7, side, 0))
              ? 1
              : 2;
      openShifts[state] |= (byte) (known << (2 * side));
    }
    return known == 1;
  }

  private FormationFootprint.Placement[] onShift(int heading, int side) {
    FormationFootprint.Placement[] known = onShifts[heading][side];
    if (known == null) {
      known = placements(heading, shift(heading, side, SHIFT_MARGIN));
      onShifts[heading][side] = known;
    }
    return known;
  }

  /** One step to the side, metres. */
  private List<Twist> shift(int heading, int side, double more) {
    double length = lattice.length(direction(heading, side)) + more;
    return List.of(new Twist(0, side == 0 ? -length : length, 0));
  }

  private static int back(int state, int heading) {
    return state < 0 ? state : (state & ~7) | heading;
  }

  /** Whether the formation can be there. */
  boolean isOpen(int state) {
    if (open[state] == 0) {
      open[state] = (byte) (clearance.isKeptAt(lattice.pose(state)) ? 1 : 2);
    }
    return open[state] == 1;
  }

  private boolean isStepOpen(int state) {
    if (openSteps[state] == 0) {
      openSteps[state] = (byte) (isOpenOnMove(state, 0) ? 1 : 2);
    }
    return openSteps[state] == 1;
  }

  private boolean isCornerOpen(int state, int corner, int end) {
    if (!isOpen(end)) {
      return false;
    }
    int known = (openCorners[state] >> (2 * corner)) & 3;
    if (known == 0) {
      known = isOpenOnMove(state, CORNERS[corner]) ? 1 : 2;
      openCorners[state] |= (byte) (known << (2 * corner));
    }
    return known == 1;
  }

  private boolean isOpenOnMove(int state, int eighths) {
    return isOpenOn(state, onMove(state & 7, eighths))
        && (!rules.isDirected() || keepsDirections(state, move(state & 7, eighths)));
  }

  private boolean isOpenOn(int state, FormationFootprint.Placement[] placements) {
    Vec2 point = lattice.pose(state).position();
    for (FormationFootprint.Placement placement : placements) {
      if (!clearance.isKeptAt(point, placement)) {
        return false;
      }
    }
    return true;
  }

  private boolean keepsDirections(int state, List<Twist> move) {
    List<Segment> pieces = move.stream().map(t -> new Segment(t.vx(), t.w(), 1, t.vy())).toList();
    return DirectionCheck.isKept(
        rules, leader -> shape.loadAt(leader).position(), lattice.pose(state), pieces);
  }

  private FormationFootprint.Placement[] onMove(int heading, int eighths) {
    FormationFootprint.Placement[] known = onMoves[heading][eighths + 2];
    if (known == null) {
      known = placements(heading, move(heading, eighths));
      onMoves[heading][eighths + 2] = known;
    }
    return known;
  }

  private FormationFootprint.Placement[] placements(int heading, List<Twist> move) {
    List<FormationFootprint.Placement> placements = new ArrayList<>();
    Pose pose = new Pose(0, 0, heading * EIGHTH);
    for (Twist piece : move) {
      pose = addAlong(pose, piece, placements);
    }
    return placements.toArray(FormationFootprint.Placement[]::new);
  }

  private List<Twist> move(int heading, int eighths) {
    return eighths == 0
        ? List.of(new Twist(lattice.length(heading), 0, 0))
        : corner(heading, eighths);
  }

  /** A straight, an arc of the smallest radius, and a straight: metres, and radians turned. */
  List<Twist> corner(int heading, int eighths) {
    double tangent = tangent(eighths);
    double angle = eighths * EIGHTH;
    return List.of(
        new Twist(legLength(heading, eighths) - tangent, 0, 0),
        new Twist(radius * Math.abs(angle), 0, angle),
        new Twist(legLength(heading + eighths & 7, eighths) - tangent, 0, 0));
  }

  private double cornerLength(int heading, int eighths) {
    return legLength(heading, eighths) + legLength(heading + eighths & 7, eighths);
  }

  /** Metres of the steps of a heading that an arc has room on. */
  private double legLength(int heading, int eighths) {
    return legs(heading, eighths) * lattice.length(heading);
  }

  private int legs(int heading, int eighths) {
    return (int) Math.ceil(tangent(eighths) / lattice.length(heading) - ROUNDING);
  }

  // t = R tan(angle/2)
  private double tangent(int eighths) {
    return radius * Math.tan(Math.abs(eighths) * EIGHTH / 2);
  }

  /**
   * The leg of a corner on from a state, or back; -1: outside.
   *
   * @param direction in which it is gone along
   * @param heading of the leg
   */
  private int along(int state, int direction, int heading, int eighths) {
    int at = state;
    for (int i = legs(heading, eighths); i > 0 && at >= 0; i--) {
      at = lattice.neighbour(at, direction);
    }
    return at;
  }

  /** Where it is looked at on a piece of a move, none before its start; returns its end. */
  private Pose addAlong(Pose from, Twist twist, List<FormationFootprint.Placement> placements) {
    double farthest =
        twist.vx()
            + Math.abs(twist.vy())
            + Math.abs(twist.w()) * shape.reach(); // that any robot drives
    int pieces = Math.max(1, (int) Math.ceil(farthest / spacing));
    Twist piece = new Twist(twist.vx() / pieces, twist.vy() / pieces, twist.w() / pieces);
    Pose pose = from;
    for (int i = 0; i < pieces; i++) {
      pose = pose.advanced(piece, 1);
      placements.add(clearance.placement(pose));
    }
    return pose;
  }
}
