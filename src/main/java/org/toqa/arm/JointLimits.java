package org.toqa.arm;

/**
 * How a joint may stand and move.
 *
 * @param least radians, counter-clockwise
 * @param most radians, counter-clockwise; more than the least
 * @param maxRate radians a second, more than 0
 * @param maxAcceleration radians a second squared, more than 0
 */
public record JointLimits(double least, double most, double maxRate, double maxAcceleration) {

  /** Radians; angles that differ by less are the same. */
  static final double SAME_ANGLE = 1e-9;

  /** Radians from straight ahead: one turn each way. */
  static final double WIDEST = 2 * Math.PI;

  public JointLimits {
    if (!(least >= -WIDEST && most <= WIDEST && least < most)) {
      throw new IllegalArgumentException(
          "a joint turns from its least angle to a greater one, each within one turn");
    }
    if (!(maxRate > 0 && Double.isFinite(maxRate) && maxAcceleration > 0)
        || !Double.isFinite(maxAcceleration)) {
      throw new IllegalArgumentException("a joint's greatest rate and acceleration are above 0");
    }
  }

  /** Whether the joint may stand so. */
  public boolean allows(double angle) {
    return angle >= least - SAME_ANGLE && angle <= most + SAME_ANGLE;
  }

  /** The nearest angle that is allowed, radians. */
  double nearest(double angle) {
    return Math.clamp(angle, least, most);
  }
}
