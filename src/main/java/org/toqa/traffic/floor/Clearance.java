package org.toqa.traffic.floor;

import java.util.BitSet;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;

/**
 * Whether robots that are so near to each other that they touch the same cell may part. Cells
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
   * Whether a robot can drive a section beside one that is stopped: the two share no cell but those
   * under the robot now, and it does not come nearer than it is. A formation that sets out shares
   * no cell with anybody: who is stopped beside it goes first.
   *
   * @param from where the section begins
   */
  static boolean isKept(TrafficRobot robot, Pose from, Section section, TrafficRobot other) {
    if (robot.isFormation()) {
      return false;
    }
    BitSet under = new BitSet();
    robot.standingCells().addTo(under);
    BitSet others = other.allocatedCells();
    others.andNot(under);
    if (section.cells().intersects(others) || other.drive.isDriving()) {
      return false;
    }
    return other.discs().stream().allMatch(disc -> isKept(robot, from, section, disc));
  }

  private static boolean isKept(TrafficRobot robot, Pose from, Section section, PlacedDisc disc) {
    double needed =
        Math.min(
            robot.radius() + disc.radius() + ENOUGH,
            robot.pose().position().distanceTo(disc.centre()));
    Pose pose = from;
    for (Segment segment : section.segments()) {
      int pieces = Math.max(1, (int) Math.ceil(Math.abs(segment.angle()) / PIECE));
      for (int i = 0; i < pieces; i++) {
        Pose next = pose.advanced(segment.twist(), segment.t() / pieces);
        if (disc.centre().distanceToLine(pose.position(), next.position()) < needed - ROUNDING) {
          return false;
        }
        pose = next;
      }
    }
    return true;
  }
}
