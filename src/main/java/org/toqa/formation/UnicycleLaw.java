package org.toqa.formation;

import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * The law for a robot that cannot go sideways, after a place that moves as such a robot does, as
 * along a path (Y. Kanayama et al., "A stable tracking control method for an autonomous mobile
 * robot", ICRA 1990). What lies beside the robot is made good by turning while it drives, so on a
 * length of path and not in a time; where the place stands it stays.
 *
 * <p>Two things differ from the paper. Its turn towards the place's heading is in proportion to the
 * place's speed and ends where that turns on the spot; here it is {@link #SLOWEST_TURN} at least.
 * Any rate above 0 leaves V = (e_x^2 + e_y^2) / 2 + (1 - cos e_th) / k_y falling. And both gains
 * are such that the error dies without swinging: k_y = (k / (2 v))^2.
 */
public record UnicycleLaw() implements FollowerLaw {

  /** k_x, 1/s: as {@link Gains} of robots that go in any direction. */
  private static final double ALONG = 3;

  /** Metres a second: no error, however large, is corrected faster. */
  private static final double MOST_SPEED = 0.1;

  /** Radians a second, likewise. */
  private static final double MOST_TURN_RATE = 1;

  /** k, 1/s: the second bound for the lag of bodies, see {@link Gains}. */
  private static final double SLOWEST_TURN = 3;

  private static final double FASTEST_TURN = Gains.LARGEST;

  /** k over the place's speed between these bounds, 1/m. */
  private static final double TURN = 10;

  /** k_y, 1/m2, at most: a robot that hardly moves does not turn for what is beside it. */
  private static final double MOST_ASIDE = 400;

  // v = v_r cos e_th + k_x e_x,  w = w_r + v_r k_y e_y + k sin e_th   (Kanayama et al., eq. 7)
  @Override
  public Twist velocity(Pose place, Twist placeTwist, Pose actual) {
    Vec2 error = place.position().minus(actual.position()).rotated(-actual.theta());
    double turn = Angles.difference(actual.theta(), place.theta());
    double speed = placeTwist.vx();
    double k = turnGain(speed);
    double correction = speed * asideGain(speed) * error.y() + k * Math.sin(turn);
    return new Twist(
        speed * Math.cos(turn) + Math.clamp(ALONG * error.x(), -MOST_SPEED, MOST_SPEED),
        0,
        placeTwist.w() + Math.clamp(correction, -MOST_TURN_RATE, MOST_TURN_RATE));
  }

  private static double turnGain(double speed) {
    return Math.clamp(TURN * Math.abs(speed), SLOWEST_TURN, FASTEST_TURN);
  }

  private static double asideGain(double speed) {
    double half = turnGain(speed) / (2 * Math.max(Math.abs(speed), 1e-6));
    return Math.min(MOST_ASIDE, half * half);
  }
}
