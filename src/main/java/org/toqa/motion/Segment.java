package org.toqa.motion;

import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * A curve segment: constant velocity for a time (Tanta, "From path to curve segments").
 *
 * @param v metres a second, forward
 * @param w radians a second, counter-clockwise
 * @param t seconds, positive
 */
public record Segment(double v, double w, double t) {
  /** Radians; a segment that bends less is seen as its chord. */
  private static final double STRAIGHT = 0.05;

  public Twist twist() {
    return new Twist(v, 0, w);
  }

  /** Metres driven. */
  public double length() {
    return Math.abs(v) * t;
  }

  /** Radians turned, counter-clockwise. */
  public double angle() {
    return w * t;
  }

  /**
   * How much of it is driven, 0 to 1.
   *
   * @param from where it begins
   * @param at on it, or nearly; the same frame
   */
  public double shareDone(Pose from, Pose at) {
    double angle = w * t;
    double share;
    if (Math.abs(angle) > STRAIGHT) {
      share = Angles.difference(from.theta(), at.theta()) / angle;
    } else {
      Vec2 forward = new Vec2(1, 0).rotated(from.theta());
      Vec2 driven = at.position().minus(from.position());
      double length = v * t;
      share = length == 0 ? 0 : (driven.x() * forward.x() + driven.y() * forward.y()) / length;
    }
    return Math.clamp(share, 0, 1);
  }

  /** What is left of it when that share is driven. */
  public Segment after(double share) {
    return new Segment(v, w, t * (1 - share));
  }
}
