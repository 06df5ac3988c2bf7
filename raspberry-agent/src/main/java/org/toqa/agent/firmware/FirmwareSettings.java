package org.toqa.agent.firmware;

import java.util.Collections;
import java.util.List;
import org.toqa.motion.ThreeWheelKinematics;

/**
 * What differs from robot to robot, and its microcontroller must know.
 *
 * @param wheels as they were measured
 * @param floorVolts of each floor sensor: below this it sees no floor
 */
public record FirmwareSettings(ThreeWheelKinematics wheels, List<Double> floorVolts) {

  /** Metres; the microcontroller takes no others. */
  public static final double LEAST_WHEEL_RADIUS = 0.010;

  public static final double MOST_WHEEL_RADIUS = 0.065;
  public static final double LEAST_CENTRE_TO_WHEEL = 0.030;
  public static final double MOST_CENTRE_TO_WHEEL = 0.500;

  public static final int FLOOR_SENSORS = 5;

  /** Volts. */
  public static final double LEAST_FLOOR_VOLTS = 0.1;

  public static final double MOST_FLOOR_VOLTS = 4.9;
  public static final double FLOOR_VOLTS = 1.0;

  /** Of a robot that nobody has measured. */
  public static final FirmwareSettings DEFAULT =
      new FirmwareSettings(
          ThreeWheelKinematics.DEFAULT, Collections.nCopies(FLOOR_SENSORS, FLOOR_VOLTS));

  public FirmwareSettings {
    floorVolts = List.copyOf(floorVolts);
  }
}
