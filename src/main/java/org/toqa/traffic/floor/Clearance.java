package org.toqa.traffic.floor;

import java.util.BitSet;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;

/**
 * Whether robots that stand so near to each other that they touch the same cell may part. Cells
 * cannot tell; here the discs themselves are looked at.
 */
final class Clearance {
  /** More than this between two robots, metres, is enough. */
  private static final double ENOUGH = 0.02;

  private static final double ROUNDING = 1e-6;

  /** An arc is looked at in pieces of at most so many radians. */
  private static final double PIECE = 0.1;

  private Clearance() {}

  /**
   * Whether a robot can drive a stretch beside one that stands: the two share no cell but those
   * under the robot now, and it does not come nearer than it is. A group that sets out shares no
   * cell with anybody: who stands beside it goes first.
   *
   * @param from where the stretch begins
   */
  static boolean isKept(Mover mover, Pose from, Stretch stretch, Mover standing) {
    if (mover.isGroup()) {
      return false;
    }
    BitSet under = new BitSet();
    mover.standing().addTo(under);
    BitSet others = standing.held();
    others.andNot(under);
    if (stretch.cells().intersects(others) || standing.isDriving()) {
      return false;
    }
    return standing.discs().stream().allMatch(disc -> isKept(mover, from, stretch, disc));
  }

  private static boolean isKept(Mover mover, Pose from, Stretch stretch, Round disc) {
    double needed =
        Math.min(
            mover.radius + disc.radius() + ENOUGH, mover.pose.position().distanceTo(disc.middle()));
    Pose pose = from;
    for (Segment segment : stretch.segments()) {
      int pieces = Math.max(1, (int) Math.ceil(Math.abs(segment.angle()) / PIECE));
      for (int i = 0; i < pieces; i++) {
        Pose next = pose.advanced(segment.twist(), segment.t() / pieces);
        if (disc.middle().distanceToLine(pose.position(), next.position()) < needed - ROUNDING) {
          return false;
        }
        pose = next;
      }
    }
    return true;
  }
}
