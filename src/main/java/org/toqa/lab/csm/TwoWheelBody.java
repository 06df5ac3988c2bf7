package org.toqa.lab.csm;

import java.util.random.RandomGenerator;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.DifferentialKinematics;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.Odometry;
import org.toqa.motion.WheelCommand;

/**
 * A robot of the paper as a body: amplitudes of 0 to 255 drive two motors that lag, wheels that are
 * not quite as large as they should be slip on the ground, and encoders count. What the counts say
 * and where it is come apart.
 */
final class TwoWheelBody {
  static final double WHEEL_RADIUS = 0.0325;
  private static final int STEPS = 10;
  private static final double MOST_AMPLITUDE = 255;

  private final DifferentialLimits limits;
  private final Faults faults;
  private final RandomGenerator random;
  private final Odometry odometry;
  private final double[] speeds = new double[2];
  private final double[] turned = new double[2];
  private Pose truth;

  /**
   * What keeps a body from doing as it is told.
   *
   * @param lag time constant of the motors, seconds; 0 for none
   * @param slip mean share of a wheel's travel that is lost on the ground, from sample to sample
   *     between nothing and twice as much
   * @param size share by which the left wheel is larger, and the right one smaller, than nominal
   */
  record Faults(double lag, double slip, double size) {}

  TwoWheelBody(Pose start, DifferentialLimits limits, Faults faults, RandomGenerator random) {
    this.limits = limits;
    this.faults = faults;
    this.random = random;
    this.truth = start;
    this.odometry =
        new Odometry(
            new DifferentialKinematics(WHEEL_RADIUS, limits.track()),
            Odometry.COUNTS_PER_WHEEL_TURN,
            start,
            counts());
  }

  /** Where it is. */
  Pose truth() {
    return truth;
  }

  /** Where its wheel counts say that it is: what it answers. */
  Pose answer() {
    return odometry.pose();
  }

  /** The speed of its faster wheel, metres a second. */
  double speed() {
    return Math.max(Math.abs(speeds[0]), Math.abs(speeds[1]));
  }

  /** Drives a sample. */
  void drive(WheelCommand command) {
    double[] wanted = {amplitudeSpeed(command.left()), amplitudeSpeed(command.right())};
    double seconds = WheelCommand.SAMPLE / STEPS;
    double share = faults.lag() <= 0 ? 1 : 1 - Math.exp(-seconds / faults.lag());
    double[] kept = {
      1 - 2 * faults.slip() * random.nextDouble(), 1 - 2 * faults.slip() * random.nextDouble()
    };
    for (int step = 0; step < STEPS; step++) {
      double[] ground = new double[2];
      for (int wheel = 0; wheel < 2; wheel++) {
        speeds[wheel] += share * (wanted[wheel] - speeds[wheel]);
        turned[wheel] += speeds[wheel] * seconds / WHEEL_RADIUS;
        double size = wheel == 0 ? 1 + faults.size() : 1 - faults.size();
        ground[wheel] = speeds[wheel] * size * kept[wheel];
      }
      Twist twist =
          new Twist((ground[0] + ground[1]) / 2, 0, (ground[1] - ground[0]) / limits.track());
      truth = truth.advanced(twist, seconds);
    }
    odometry.update(counts());
  }

  private double amplitudeSpeed(WheelCommand.Wheel wheel) {
    double speed = wheel.amplitude() * limits.wheelSpeed() / MOST_AMPLITUDE;
    return wheel.isForward() ? speed : -speed;
  }

  /** Of its encoders, left and right. */
  int[] counts() {
    double perRadian = Odometry.COUNTS_PER_WHEEL_TURN / (2 * Math.PI);
    return new int[] {
      (int) Math.floor(turned[0] * perRadian), (int) Math.floor(turned[1] * perRadian)
    };
  }
}
