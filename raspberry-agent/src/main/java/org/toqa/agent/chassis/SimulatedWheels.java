package org.toqa.agent.chassis;

import org.toqa.motion.DifferentialKinematics;
import org.toqa.motion.DriveKind;
import org.toqa.motion.ThreeWheelKinematics;
import org.toqa.motion.WheelKinematics;

/**
 * The wheels of a simulated body, and what its encoders do not see of them.
 *
 * @param slip standard deviation of what a wheel slips in a step, as a share of what it turns
 * @param sizeError standard deviation of a wheel's constant error in size, as a share of it
 */
public record SimulatedWheels(WheelKinematics kinematics, double slip, double sizeError) {

  private static final WheelKinematics TWO_WHEELS = new DifferentialKinematics(0.04, 0.20);

  /**
   * Those of a robot of a kind, all of their nominal size.
   *
   * @param slip see the class: a share, at least 0
   */
  public static SimulatedWheels of(DriveKind kind, double slip) {
    return switch (kind) {
      case OMNI -> omni(slip, 0);
      case DIFFERENTIAL -> differential(slip, 0);
    };
  }

  /** What a body on these wheels can do. */
  DriveKind kind() {
    return switch (kinematics) {
      case ThreeWheelKinematics _ -> DriveKind.OMNI;
      case DifferentialKinematics _ -> DriveKind.DIFFERENTIAL;
    };
  }

  /** Metres between the wheels of a body that has two; 0: it has others. */
  public double track() {
    return switch (kinematics) {
      case ThreeWheelKinematics _ -> 0;
      case DifferentialKinematics(double _, double metres) -> metres;
    };
  }

  /**
   * Three omnidirectional wheels.
   *
   * @param slip see the class: a share, at least 0
   * @param sizeError see the class: a share, at least 0
   */
  public static SimulatedWheels omni(double slip, double sizeError) {
    return new SimulatedWheels(ThreeWheelKinematics.DEFAULT, slip, sizeError);
  }

  /**
   * Two wheels on one axle, of 0.04 m radius, 0.20 m apart.
   *
   * @param slip see the class: a share, at least 0
   * @param sizeError see the class: a share, at least 0
   */
  public static SimulatedWheels differential(double slip, double sizeError) {
    return new SimulatedWheels(TWO_WHEELS, slip, sizeError);
  }
}
