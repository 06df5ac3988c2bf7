package org.toqa.agent.drive;

import org.toqa.geometry.Twist;

/**
 * What a robot's body may be asked for.
 *
 * @param speed metres a second
 * @param turnRate radians a second
 * @param acceleration metres a second squared
 * @param turnAcceleration radians a second squared
 */
public record MotionLimits(
    double speed, double turnRate, double acceleration, double turnAcceleration) {

  /** The same curve, driven no faster than speed and turn rate allow. */
  public Twist clampedTwist(Twist wanted) {
    double share =
        Math.min(speed / Math.hypot(wanted.vx(), wanted.vy()), turnRate / Math.abs(wanted.w()));
    return share < 1 ? wanted.times(share) : wanted;
  }
}
