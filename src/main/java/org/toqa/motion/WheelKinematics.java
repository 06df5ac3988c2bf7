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
   * The wheels' rates that make a velocity.
   *
   * @param twist in the robot's own frame
   * @return radians a second of each wheel, positive in the direction of the implementation's
   *     formulas
   */
  double[] rates(Twist twist);

  /**
   * The velocity that the wheels make.
   *
   * @param rates radians a second of each wheel, likewise
   * @return in the robot's own frame
   */
  Twist twist(double... rates);

  /**
   * Refuses a size that no robot has.
   *
   * @throws IllegalArgumentException if it is not positive and finite
   */
  static void requireLength(String name, double metres) {
    if (!(metres > 0) || Double.isInfinite(metres)) {
      throw new IllegalArgumentException(
          "The " + name + " must be a positive number of metres, not " + metres + ".");
    }
  }
}
