package org.toqa.motion;

import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * A curve segment: constant velocity for a time (Tanta, "From path to curve segments"); or a shift,
 * which keeps the heading.
 *
 * @param v metres a second, forward
 * @param w radians a second, counter-clockwise
 * @param t seconds, positive
 * @param u metres a second, to the left; 0 but where v and w are 0
 */
public record Segment(double v, double w, double t, double u) {
  /** Radians; a segment that bends less is seen as its chord. */
  private static final double STRAIGHT = 0.05;

  /** One that is driven forward, backward or on the spot. */
  public Segment(double v, double w, double t) {
    this(v, w, t, 0);
  }

  /**
   * A shift.
   *
   * @param u metres a second, to the left
   * @param t seconds, positive
   */
  public static Segment shift(double u, double t) {
    return new Segment(0, 0, t, u);
  }

  public Twist twist() {
    return new Twist(v, u, w);
  }

  /** Metres a second, never negative. */
  public double speed() {
    return Math.abs(v) + Math.abs(u); // one of them is 0
  }

  public boolean shifts() {
    return u != 0;
  }

  /** Metres driven. */
  public double length() {
    return speed() * t;
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
      Vec2 driven = at.position().minus(from.position()).rotated(-from.theta());
      double length = (shifts() ? u : v) * t;
      share = length == 0 ? 0 : (shifts() ? driven.y() : driven.x()) / length;
    }
    return Math.clamp(share, 0, 1);
  }

  /** What is left of it when that share is driven. */
  public Segment after(double share) {
    return lasting(t * (1 - share));
  }

  /**
   * The same for another time.
   *
   * @param seconds positive
   */
  public Segment lasting(double seconds) {
    return new Segment(v, w, seconds, u);
  }

  /**
   * The same, driven more slowly.
   *
   * @param share of its speed, above 0
   */
  public Segment slowed(double share) {
    return new Segment(v * share, w * share, t / share, u * share);
  }
}
