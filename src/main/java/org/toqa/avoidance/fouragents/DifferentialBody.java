package org.toqa.avoidance.fouragents;

import org.toqa.geometry.Twist;

/**
 * A round robot on two driven wheels.
 *
 * @param radius metres
 * @param track metres between the wheels
 * @param wheelSpeed metres a second, the most of each wheel, either direction
 * @param acceleration metres a second squared, the most of each wheel
 */
public record DifferentialBody(
    double radius, double track, double wheelSpeed, double acceleration) {

  /**
   * The seed's robot: 70 mm wide, wheels 53 mm apart. How fast it drove is not published; 0.1 m/s
   * and 1 m/s2 are ours, a tenth of what its motors do.
   */
  public static final DifferentialBody KHEPERA_II = new DifferentialBody(0.035, 0.053, 0.1, 1);

  /**
   * @throws IllegalArgumentException if one is not positive and finite
   */
  public DifferentialBody {
    for (double number : new double[] {radius, track, wheelSpeed, acceleration}) {
      if (!(number > 0) || Double.isInfinite(number)) {
        throw new IllegalArgumentException(
            "A measure of a robot is a positive number, not " + number + ".");
      }
    }
  }

  /** Metres from full speed to standstill: v^2 / (2 a). */
  public double stoppingDistance() {
    return wheelSpeed * wheelSpeed / (2 * acceleration);
  }

  /**
   * The wheels for a velocity; on the same curve, slower, where a wheel cannot be as fast.
   *
   * @param twist without a sideways part
   */
  WheelVelocities wheels(Twist twist) {
    // vl = v - w L / 2,  vr = v + w L / 2
    double turning = twist.w() * track / 2;
    return limited(new WheelVelocities(twist.vx() - turning, twist.vx() + turning));
  }

  /** The same ratio of the wheels, no wheel faster than it can be. */
  private WheelVelocities limited(WheelVelocities wheels) {
    double largest = Math.max(Math.abs(wheels.left()), Math.abs(wheels.right()));
    double factor = largest <= wheelSpeed ? 1 : wheelSpeed / largest;
    return new WheelVelocities(
        Math.clamp(wheels.left() * factor, -wheelSpeed, wheelSpeed),
        Math.clamp(wheels.right() * factor, -wheelSpeed, wheelSpeed));
  }

  /**
   * How the body moves with these wheels.
   *
   * @return in the robot's frame
   */
  public Twist twist(WheelVelocities wheels) {
    return new Twist(
        (wheels.left() + wheels.right()) / 2, 0, (wheels.right() - wheels.left()) / track);
  }
}
