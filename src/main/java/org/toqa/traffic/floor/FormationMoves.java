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
 * margin, meets nothing on it, and the middle of its load keeps the directions of the floor. States
 * are those of {@link FormationLattice}.
 */
final class FormationMoves {
  /** In eighths of a full turn. */
  private static final int[] CORNERS = {-1, 1, -2, 2};

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
    Vec2 point = lattice.pose(state).position();
    for (FormationFootprint.Placement placement : onMove(state & 7, eighths)) {
      if (!clearance.isKeptAt(point, placement)) {
        return false;
      }
    }
    return !rules.isDirected() || keepsDirections(state, eighths);
  }

  private boolean keepsDirections(int state, int eighths) {
    List<Segment> pieces =
        move(state & 7, eighths).stream().map(t -> new Segment(t.vx(), t.w(), 1)).toList();
    return DirectionCheck.isKept(
        rules, leader -> shape.loadAt(leader).position(), lattice.pose(state), pieces);
  }

  private FormationFootprint.Placement[] onMove(int heading, int eighths) {
    FormationFootprint.Placement[] known = onMoves[heading][eighths + 2];
    if (known == null) {
      List<FormationFootprint.Placement> placements = new ArrayList<>();
      Pose pose = new Pose(0, 0, heading * EIGHTH);
      for (Twist piece : move(heading, eighths)) {
        pose = addAlong(pose, piece, placements);
      }
      known = placements.toArray(FormationFootprint.Placement[]::new);
      onMoves[heading][eighths + 2] = known;
    }
    return known;
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
    double farthest = twist.vx() + Math.abs(twist.w()) * shape.reach(); // that any robot drives
    int pieces = Math.max(1, (int) Math.ceil(farthest / spacing));
    Twist piece = new Twist(twist.vx() / pieces, 0, twist.w() / pieces);
    Pose pose = from;
    for (int i = 0; i < pieces; i++) {
      pose = pose.advanced(piece, 1);
      placements.add(clearance.placement(pose));
    }
    return pose;
  }
}
