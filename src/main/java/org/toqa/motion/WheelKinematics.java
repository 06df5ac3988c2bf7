package org.toqa.motion;

import org.toqa.geometry.Twist;

/**
 * How a robot's own velocity and its wheels' speeds belong together. Both directions are linear, so
 * they hold for small displacements too, taken as the velocities of a second.
 */
public sealed interface WheelKinematics permits ThreeWheelKinematics, DifferentialKinematics {

  /** How many wheels are driven. */
  int wheelCount();

  /**
   * The wheels' speeds that make a velocity.
   *
   * @param twist in the robot's own frame
   */
  WheelSpeeds speeds(Twist twist);

  /**
   * The velocity that the wheels make.
   *
   * @return in the robot's own frame
   */
  Twist twist(WheelSpeeds speeds);

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
