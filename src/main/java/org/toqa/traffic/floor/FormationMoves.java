package org.toqa.traffic.floor;

import java.util.List;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/**
 * How a formation can be led over its lattice: a move is a step along the heading, or a corner of
 * 45 or 90 degrees with as much of a leg before and behind it as an arc of the smallest radius
 * needs, so that no path has a tighter one. A move is open where the whole formation, with a
 * margin, meets nothing on it. States are those of {@link FormationLattice}.
 */
final class FormationMoves {
  /** In eighths of a full turn. */
  private static final int[] CORNERS = {-1, 1, -2, 2};

  private static final double ROUNDING = FormationLattice.ROUNDING;
  private static final double EIGHTH = FormationLattice.EIGHTH;

  private final FormationLattice lattice;
  private final Shape shape;
  private final FormationClearance clearance;
  private final double radius;

  /** Metres. */
  private final double spacing;

  private final byte[] open;
  private final byte[] openSteps;

  FormationMoves(FormationLattice lattice, Shape shape, FormationClearance clearance) {
    this.lattice = lattice;
    this.shape = shape;
    this.clearance = clearance;
    this.radius = shape.smallestRadius();
    this.spacing = clearance.spacing();
    this.open = new byte[lattice.stateCount()];
    this.openSteps = new byte[open.length];
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
    for (int eighths : CORNERS) {
      int next = heading + eighths & 7;
      int end = along(along(state, heading, heading, eighths), next, next, eighths);
      if (end >= 0 && isCornerOpen(state, eighths, end)) {
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
    for (int eighths : CORNERS) {
      int before = heading - eighths & 7;
      int corner = along(state, heading + 4 & 7, heading, eighths);
      int from = back(along(corner, before + 4 & 7, before, eighths), before);
      if (from >= 0 && isOpen(from) && isCornerOpen(from, eighths, state)) {
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
      boolean isOpen = isOpenAlong(lattice.pose(state), lattice.length(state & 7), 0);
      openSteps[state] = (byte) (isOpen ? 1 : 2);
    }
    return openSteps[state] == 1;
  }

  private boolean isCornerOpen(int state, int eighths, int end) {
    if (!isOpen(end)) {
      return false;
    }
    Pose pose = lattice.pose(state);
    for (Twist piece : corner(state & 7, eighths)) {
      if (!isOpenAlong(pose, piece.vx(), piece.w())) {
        return false;
      }
      pose = pose.advanced(piece, 1);
    }
    return true;
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
}
