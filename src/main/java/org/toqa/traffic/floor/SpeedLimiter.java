package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import java.util.NavigableSet;
import java.util.TreeSet;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.grid.MoveRules;
import org.toqa.motion.Segment;

/**
 * Slows segments down where they lead through areas with a speed limit, and a little before and
 * behind these ({@link MoveRules#SLOWING}). A straight is cut where a limit begins or ends; an arc
 * is driven slowly as a whole. Of a group no member is faster than the limit where it is itself.
 */
final class SpeedLimiter {
  /** Metres; no shorter pieces are cut off. */
  private static final double SHORTEST = 0.01;

  /** Radians; an arc is looked at in pieces that turn no more. */
  private static final double PIECE = Math.PI / 18;

  private SpeedLimiter() {}

  /**
   * The segment in pieces, driven as slowly as the limits want.
   *
   * @param members where those stand who drive by it, in the frame of the robot that it is for
   * @param start where it begins, map frame
   */
  static List<Segment> limited(MoveRules rules, List<Vec2> members, Pose start, Segment segment) {
    if (rules.speedLimits().isEmpty() || segment.twist().equals(Twist.ZERO)) {
      return List.of(segment);
    }
    List<Segment> pieces = new ArrayList<>();
    Pose pose = start;
    double done = 0;
    for (double share : ends(rules, members, start, segment)) {
      Segment piece = segment.lasting((share - done) * segment.t());
      pieces.add(slowed(piece, share(rules, members, pose, piece)));
      pose = pose.advanced(piece.twist(), piece.t());
      done = share;
    }
    return pieces;
  }

  /** Where pieces end, as shares of the segment, rising to 1. */
  private static NavigableSet<Double> ends(
      MoveRules rules, List<Vec2> members, Pose start, Segment segment) {
    NavigableSet<Double> ends = new TreeSet<>(List.of(1.0));
    if (segment.w() == 0) {
      double least = SHORTEST / segment.length();
      Pose end = start.advanced(segment.twist(), segment.t());
      for (Vec2 member : members) {
        for (double share : rules.speedChanges(at(start, member), at(end, member))) {
          Double before = ends.floor(share + least);
          if (share > least && share < 1 - least && (before == null || before < share - least)) {
            ends.add(share);
          }
        }
      }
    }
    return ends;
  }

  /** At what share of its speed a piece may be driven, up to 1. */
  private static double share(MoveRules rules, List<Vec2> members, Pose start, Segment piece) {
    int parts = 1 + (int) (Math.abs(piece.angle()) / PIECE);
    double share = 1;
    for (Vec2 member : members) {
      // v_p = v + w x p
      double speed =
          Math.hypot(piece.v() - piece.w() * member.y(), piece.u() + piece.w() * member.x());
      Pose pose = start;
      for (int i = 0; i < parts && speed > 0; i++) {
        Pose next = pose.advanced(piece.twist(), piece.t() / parts);
        share = Math.min(share, rules.speedLimit(at(pose, member), at(next, member)) / speed);
        pose = next;
      }
    }
    return share;
  }

  private static Segment slowed(Segment piece, double share) {
    return share >= 1 ? piece : piece.slowed(share);
  }

  private static Vec2 at(Pose pose, Vec2 member) {
    return pose.position().plus(member.rotated(pose.theta()));
  }
}
