package org.toqa.motion;

/**
 * How fast wheels turn, radians a second, either direction.
 *
 * @param ratedRate radians a second that the motor is rated for, with its gear
 * @param maxRate radians a second that the firmware commands at most; faster ones are slowed down,
 *     all wheels alike
 */
public record WheelLimits(double ratedRate, double maxRate) {

  /** 220 and 150 turns a minute, of the wheels of {@link ThreeWheelKinematics#DEFAULT}. */
  public static final WheelLimits DEFAULT =
      new WheelLimits(220 / 60.0 * 2 * Math.PI, 150 / 60.0 * 2 * Math.PI);
}
