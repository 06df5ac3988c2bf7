package org.toqa.agent.firmware;

import org.toqa.arm.Arm;

/**
 * What differs from arm to arm, and its microcontroller must know: how its joints may turn, and how
 * its servos and sensors are. The lengths of its links are none of this: places become angles in
 * the daemon.
 *
 * @param openPulse microseconds, of the hand's servo
 * @param closedPulse likewise
 * @param emptyVolts of the load sensor, with nothing in the hand
 * @param voltsPerKilogram by how much it then tells more
 */
public record ArmSettings(
    Arm arm,
    JointWiring shoulder,
    JointWiring elbow,
    double openPulse,
    double closedPulse,
    double emptyVolts,
    double voltsPerKilogram) {

  /** Microseconds; the microcontroller takes no others. */
  public static final double SHORTEST_PULSE = 400;

  public static final double LONGEST_PULSE = 2_600;
  public static final double LEAST_PULSES_APART = 100;

  public static final double MOST_VOLTS = 5;
  public static final double LEAST_VOLTS_APART = 0.5;
  public static final double LEAST_VOLTS_PER_KILOGRAM = 0.1;

  /** Radians a second squared: no faster does the microcontroller change a joint's rate. */
  static final double MOST_ACCELERATION = 65.535;

  /** Radians a second. */
  static final double MOST_RATE = 13;

  /**
   * A joint's servo and potentiometer at the least angle of the joint, and at the greatest.
   *
   * @param leastPulse microseconds
   * @param mostPulse microseconds
   */
  public record JointWiring(
      double leastPulse, double mostPulse, double leastVolts, double mostVolts) {

    public static final JointWiring DEFAULT = new JointWiring(500, 2_500, 0.5, 4.5);
  }

  /** With servos and sensors as nobody has changed them. */
  public static ArmSettings of(Arm arm) {
    return new ArmSettings(arm, JointWiring.DEFAULT, JointWiring.DEFAULT, 1_000, 2_000, 0.5, 1);
  }
}
