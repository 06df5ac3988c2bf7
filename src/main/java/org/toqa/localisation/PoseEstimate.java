package org.toqa.localisation;

import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * Where a robot is taken to be, and how well that is known: a normal distribution of x, y (metres)
 * and heading (radians), map frame. The fields are its mean and the entries of its covariance,
 * which is symmetric.
 */
public record PoseEstimate(
    Pose pose, double xx, double xy, double xt, double yy, double yt, double tt) {

  /**
   * Of errors that have nothing to do with each other.
   *
   * @param metres standard deviation of x and of y
   * @param radians the same of the heading
   */
  public static PoseEstimate of(Pose pose, double metres, double radians) {
    double p = metres * metres;
    return new PoseEstimate(pose, p, 0, 0, p, 0, radians * radians);
  }

  /** Standard deviation in the direction in which it is known worst, metres. */
  public double positionDeviation() {
    double half = (xx + yy) / 2;
    double apart = Math.hypot((xx - yy) / 2, xy);
    return Math.sqrt(half + apart);
  }

  /** Standard deviation, radians. */
  public double headingDeviation() {
    return Math.sqrt(tt);
  }

  /**
   * After a step of a robot with two wheels by its odometry (R. Siegwart and I. Nourbakhsh,
   * "Introduction to Autonomous Mobile Robots", 2004, section 5.2.4: error model for odometric
   * position estimation).
   *
   * @param step where the robot is after it, in the frame of where it was; not half a turn
   * @param track metres between the wheels
   * @param noise k: what a wheel rolls over s metres has the variance k |s|; metres
   */
  PoseEstimate moved(Pose step, double track, double noise) {
    Pose then = pose.compose(step);
    // F = d(x', y', theta') / d(x, y, theta) is the identity, but for the column of theta
    double a = pose.y() - then.y();
    double b = then.x() - pose.x();
    double travelled = Math.copySign(Math.hypot(step.x(), step.y()), step.x());
    double right = noise * Math.abs(travelled + step.theta() * track / 2);
    double left = noise * Math.abs(travelled - step.theta() * track / 2);
    double along = (right + left) / 4;
    double both = (right - left) / (2 * track);
    double turned = (right + left) / (track * track);
    double c = Math.cos(pose.theta() + step.theta() / 2);
    double s = Math.sin(pose.theta() + step.theta() / 2);
    // P' = F P F' + G Q G', Q = diag(k |s_r|, k |s_l|)   (eq. 5.9)
    return new PoseEstimate(
        then,
        xx + 2 * a * xt + a * a * tt + along * c * c,
        xy + a * yt + b * xt + a * b * tt + along * c * s,
        xt + a * tt + both * c,
        yy + 2 * b * yt + b * b * tt + along * s * s,
        yt + b * tt + both * s,
        tt + turned);
  }

  /** What a measurement depends on: its derivatives by x, y and heading. */
  record Slope(double x, double y, double t) {}

  /** Variance of a measurement that has none of its own. */
  double variance(Slope h) {
    return h.x() * (xx * h.x() + 2 * (xy * h.y() + xt * h.t()))
        + h.y() * (yy * h.y() + 2 * yt * h.t())
        + h.t() * h.t() * tt;
  }

  /**
   * With a measurement taken into account.
   *
   * @param innovation what was measured, less what was expected here
   * @param variance of what was measured, above 0
   */
  PoseEstimate corrected(Slope h, double innovation, double variance) {
    // S = H P H' + R,  K = P H' / S,  P' = P - K S K'
    double s = variance(h) + variance;
    double px = xx * h.x() + xy * h.y() + xt * h.t();
    double py = xy * h.x() + yy * h.y() + yt * h.t();
    double pt = xt * h.x() + yt * h.y() + tt * h.t();
    double gain = innovation / s;
    Vec2 place = pose.position().plus(new Vec2(px, py).times(gain));
    return new PoseEstimate(
        new Pose(place.x(), place.y(), pose.theta() + pt * gain),
        Math.max(0, xx - px * px / s),
        xy - px * py / s,
        xt - px * pt / s,
        Math.max(0, yy - py * py / s),
        yt - py * pt / s,
        Math.max(0, tt - pt * pt / s));
  }

  /**
   * With standard deviations of so much at least.
   *
   * @param metres of x and of y
   * @param radians of the heading
   */
  PoseEstimate noSurerThan(double metres, double radians) {
    double p = metres * metres;
    return new PoseEstimate(
        pose, Math.max(xx, p), xy, xt, Math.max(yy, p), yt, Math.max(tt, radians * radians));
  }
}
