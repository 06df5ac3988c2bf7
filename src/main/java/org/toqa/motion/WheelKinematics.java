package org.toqa.motion;

import org.toqa.geometry.Twist;

/**
 * How a robot's own velocity and its wheels' rates belong together. Both directions are linear, so
 * they hold for small displacements too: turned angles instead of rates, metres and radians instead
 * of velocities.
 */
public sealed interface WheelKinematics permits ThreeWheelKinematics, DifferentialKinematics {

  /** How many wheels are driven. */
  int wheelCount();

  /**
   * Radians a second of each wheel, positive the way it turns when the robot obeys the formulas.
   */
  double[] rates(Twist twist);

  /** The robot's velocity that these rates, radians a second, make. */
  Twist twist(double... rates);

  /** Refuses a size that no robot has. */
  static void requireLength(String name, double metres) {
    if (!(metres > 0) || Double.isInfinite(metres)) {
      throw new IllegalArgumentException(
          "The " + name + " must be a positive number of metres, not " + metres + ".");
    }
  }
}
