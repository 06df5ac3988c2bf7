package org.toqa.avoidance.fouragents;

import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/**
 * Tracks a reference by sliding mode. With the reference's pose in the robot's frame (xe, ye, the):
 *
 * <pre>
 * xe' = w ye - v + vr cos the,  ye' = -w xe + vr sin the,  the' = wr - w   (Kanayama 1990)
 * s1 = xe,  s2 = the + atan(k vr ye)
 * s' = -Q s - P sat(s / boundary)
 * </pre>
 *
 * <p>solved for v and w. On s1 = s2 = 0 the robot is abeam of the reference and heads towards its
 * line. The seed has k = 1, in whatever unit; vr ye is an area by time, so k is a parameter here.
 *
 * <p>s is within the boundary layer after at most (1/Q) ln((Q |s0| + P) / (Q boundary + P)) seconds
 * as long as the wheels do what they are told and 1 + g xe >= 0.2, with g = k vr / (1 + (k vr
 * ye)^2): beyond that the factor of w is kept from zero, and s2 is reached later. With k = 1 /
 * (wheel speed x margin) and vr at most 0.8 of the wheel speed that is so from all errors up to the
 * margin, where a reference begins anew. Where the wheels' limits cut in it takes longer: the
 * seed's robot 4 s at most.
 *
 * @param along of s1, metres
 * @param turning of s2, radians
 * @param cross k, s/m^2
 */
record SlidingMode(Reaching along, Reaching turning, double cross) {

  /**
   * How a surface is reached: {@code s' = -Q s - P sat(s / boundary)}.
   *
   * @param gain Q, 1/s
   * @param switching P, units of s a second
   * @param boundary units of s: within it the law is linear, which limits chattering
   */
  record Reaching(double gain, double switching, double boundary) {
    // Q s + P sat(s / boundary)
    double rate(double s) {
      return gain * s + switching * Math.clamp(s / boundary, -1, 1);
    }
  }

  /**
   * What is tracked at a moment.
   *
   * @param pose map frame
   * @param speed vr, metres a second
   * @param turnRate wr, radians a second
   */
  record Reference(Pose pose, double speed, double turnRate) {}

  /** The two sliding surfaces. */
  record Surfaces(double s1, double s2) {}

  Surfaces surfaces(Pose robot, Reference reference) {
    Pose error = robot.relative(reference.pose());
    return ofError(error, reference);
  }

  private Surfaces ofError(Pose error, Reference reference) {
    return new Surfaces(
        error.x(), error.theta() + Math.atan(cross * reference.speed() * error.y()));
  }

  /**
   * The velocity that drives both surfaces to zero, before any limit of the wheels.
   *
   * @param robot map frame
   * @return in the robot's frame
   */
  Twist velocity(Pose robot, Reference reference) {
    Pose error = robot.relative(reference.pose());
    Surfaces s = ofError(error, reference);
    double vr = reference.speed();
    // d atan(k vr ye) = g ye',  g = k vr / (1 + (k vr ye)^2)
    double inside = cross * vr * error.y();
    double g = cross * vr / (1 + inside * inside);
    // s2' = wr - w + g (-w xe + vr sin the) = -rate(s2)
    double wanted = reference.turnRate() + g * vr * Math.sin(error.theta()) + turning.rate(s.s2());
    double factor = 1 + g * error.x();
    double w = wanted / (Math.abs(factor) < 0.2 ? Math.copySign(0.2, factor) : factor);
    // s1' = w ye - v + vr cos the = -rate(s1)
    double v = w * error.y() + vr * Math.cos(error.theta()) + along.rate(s.s1());
    return new Twist(v, 0, w);
  }
}
