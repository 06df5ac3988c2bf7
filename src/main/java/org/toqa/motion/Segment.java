package org.toqa.motion;

import org.toqa.geometry.Twist;

/**
 * A curve segment: constant velocity for a time (Tanta, "From path to curve segments").
 *
 * @param v metres a second, forward
 * @param w radians a second, counter-clockwise
 * @param t seconds, positive
 */
public record Segment(double v, double w, double t) {

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
}
