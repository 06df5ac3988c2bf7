package org.toqa.motion;

import java.util.function.IntToDoubleFunction;

/**
 * How fast each driven wheel turns, radians a second, positive in the direction of its kinematics'
 * formulas. The wheels stand in the order of those formulas: of {@link ThreeWheelKinematics} wheels
 * 1, 2 and 3, of {@link DifferentialKinematics} left and right; a body with two has no third, whose
 * speed is 0.
 */
public record WheelSpeeds(double first, double second, double third) {

  public static final WheelSpeeds ZERO = new WheelSpeeds(0, 0, 0);

  /**
   * @param wheels 2 or 3
   * @param speedOf radians a second of the wheel with this index, from 0
   */
  public static WheelSpeeds of(int wheels, IntToDoubleFunction speedOf) {
    return new WheelSpeeds(
        speedOf.applyAsDouble(0),
        speedOf.applyAsDouble(1),
        wheels < 3 ? 0 : speedOf.applyAsDouble(2));
  }

  /** That of the fastest wheel, radians a second, not below 0. */
  public double largest() {
    return Math.max(Math.abs(first), Math.max(Math.abs(second), Math.abs(third)));
  }

  public WheelSpeeds times(double factor) {
    return new WheelSpeeds(first * factor, second * factor, third * factor);
  }

  public WheelSpeeds plus(WheelSpeeds other) {
    return new WheelSpeeds(first + other.first, second + other.second, third + other.third);
  }

  public WheelSpeeds minus(WheelSpeeds other) {
    return plus(other.times(-1));
  }

  /**
   * The same direction, no wheel faster than {@code limit}.
   *
   * @param limit radians a second, not below 0
   */
  public WheelSpeeds limited(double limit) {
    double largest = largest();
    return largest <= limit ? this : times(limit / largest);
  }
}
