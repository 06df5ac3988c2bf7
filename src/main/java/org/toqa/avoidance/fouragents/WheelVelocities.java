package org.toqa.avoidance.fouragents;

/**
 * How fast the two wheels roll over the floor.
 *
 * @param left vl, metres a second, forward
 * @param right vr, metres a second, forward
 */
public record WheelVelocities(double left, double right) {
  public static final WheelVelocities ZERO = new WheelVelocities(0, 0);
}
