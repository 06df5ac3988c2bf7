package org.toqa.motion;

/**
 * What a robot with two driven wheels may do on a curve (CSM-MAMRS).
 *
 * @param wheelSpeed metres a second, of each wheel, either direction
 * @param track metres between the wheels
 * @param acceleration metres a second squared, along the curve
 * @param lateralAcceleration metres a second squared, across it
 * @param jerk metres a second cubed, along the curve
 */
public record DifferentialLimits(
    double wheelSpeed, double track, double acceleration, double lateralAcceleration, double jerk) {

  /** 0.52 m/s as in CSM-MAMRS; the others are ours, mild for a robot of 20 cm. */
  public static final DifferentialLimits DEFAULT = new DifferentialLimits(0.52, 0.15, 0.5, 0.8, 4);

  /**
   * @throws IllegalArgumentException if one is not positive and finite
   */
  public DifferentialLimits {
    for (double limit : new double[] {wheelSpeed, track, acceleration, lateralAcceleration, jerk}) {
      if (!(limit > 0) || Double.isInfinite(limit)) {
        throw new IllegalArgumentException(
            "A limit of a robot is a positive number, not " + limit + ".");
      }
    }
  }

  /**
   * The fastest that both wheels and the lateral acceleration allow on a curve, metres a second.
   *
   * @param curvature radians a metre, either sign
   */
  public double speedAt(double curvature) {
    // |v| (1 + |kappa| L / 2) <= wheel speed; v^2 |kappa| <= lateral acceleration
    double bend = Math.abs(curvature);
    return Math.min(
        wheelSpeed / (1 + bend * track / 2),
        Math.sqrt(lateralAcceleration / Math.max(bend, 1e-12)));
  }
}
