package org.toqa.lab.csm;

import java.util.List;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Run;
import org.toqa.motion.DifferentialLimits;

/** What the paper does not tell of its robots and planner, chosen before any result. */
final class CsmParameters {
  static final String SOURCE =
      "CSM-MAMRS: Client-Server Model for a Multi-Agent Mobile Robot System, 2023";

  static final Parameter RADIUS =
      new Parameter(
          "radius",
          0.10,
          0.05,
          0.10,
          "m",
          "of the disc that is planned for; starts lie 10 cm from the border");

  static final Parameter ITERATIONS =
      new Parameter("iterations", 4000, 100, 100_000, "", "of the planner, for each path");

  static final Parameter DELAY =
      new Parameter("delay", 0.040, 0, 0.3, "s", "from a command to its answer");

  static final Parameter LAG =
      new Parameter("lag", 0.05, 0, 0.5, "s", "time constant of the motors");

  static final Parameter SLIP =
      new Parameter("slip", 0.01, 0, 0.2, "", "mean share of a wheel's travel that slips");

  static final Parameter WHEEL_SIZE =
      new Parameter("wheel-size", 0.001, 0, 0.05, "", "share by which wheels are unlike");

  static final Parameter RANGE_NOISE =
      new Parameter(
          "range-noise", 0.01, 0.001, 0.1, "m", "standard deviation of an ultrasonic range");

  static final List<Parameter> OF_BODY = List.of(DELAY, LAG, SLIP, WHEEL_SIZE, RANGE_NOISE);

  /** Seconds: the lag that the tracker takes motors to have, whatever {@link #LAG} is. */
  static final double RESPONSE = 0.05;

  /** What wheels can do. */
  static final DifferentialLimits LIMITS = DifferentialLimits.DEFAULT;

  /** What is planned with: a tenth of the wheels' speed is left to the law that corrects. */
  static final DifferentialLimits PLANNED =
      new DifferentialLimits(
          0.9 * LIMITS.wheelSpeed(),
          LIMITS.track(),
          LIMITS.acceleration(),
          LIMITS.lateralAcceleration(),
          LIMITS.jerk());

  private CsmParameters() {}

  static TwoWheelBody.Faults faults(Run run) {
    return new TwoWheelBody.Faults(run.value(LAG), run.value(SLIP), run.value(WHEEL_SIZE));
  }
}
