package org.toqa.motion;

/**
 * How fast a planned path is driven.
 *
 * @param forward metres a second on straights, and the most on arcs
 * @param arcRate radians a second, the most on arcs: a tight arc is driven slower than {@code
 *     forward}
 * @param spotRate radians a second of a turn on the spot
 */
public record DriveSpeeds(double forward, double arcRate, double spotRate) {

  /** 0.25 m/s as in Tanta, and rates at which the wheels stay well below their limit. */
  public static final DriveSpeeds DEFAULT = new DriveSpeeds(0.25, 1.5, 1.5);

  /**
   * @throws IllegalArgumentException if one is not positive and finite
   */
  public DriveSpeeds {
    requirePositive("forward", forward);
    requirePositive("arcRate", arcRate);
    requirePositive("spotRate", spotRate);
  }

  /**
   * The same, but nowhere faster than a robot can be.
   *
   * @param maxSpeed metres a second, above 0
   * @param maxTurnRate radians a second, above 0
   * @throws IllegalArgumentException if one is not above 0
   */
  public DriveSpeeds atMost(double maxSpeed, double maxTurnRate) {
    return new DriveSpeeds(
        Math.min(forward, maxSpeed),
        Math.min(arcRate, maxTurnRate),
        Math.min(spotRate, maxTurnRate));
  }

  /** What both can do, as of robots that carry together. */
  public DriveSpeeds slower(DriveSpeeds other) {
    return new DriveSpeeds(
        Math.min(forward, other.forward),
        Math.min(arcRate, other.arcRate),
        Math.min(spotRate, other.spotRate));
  }

  private static void requirePositive(String name, double value) {
    if (!(value > 0) || Double.isInfinite(value)) {
      throw new IllegalArgumentException(
          "The speed '" + name + "' must be a positive number, not " + value + ".");
    }
  }
}
