package org.toqa.geometry;

/** Arithmetic of angles in radians, counter-clockwise. */
public final class Angles {
  private Angles() {}

  /** The same direction, radians, in (-pi, pi]. */
  public static double normalise(double angle) {
    double turned = angle - 2 * Math.PI * Math.floor((angle + Math.PI) / (2 * Math.PI));
    return turned <= -Math.PI ? turned + 2 * Math.PI : turned;
  }

  /**
   * The shorter turn that leads from one direction to the other, radians, counter-clockwise, in
   * (-pi, pi].
   */
  public static double difference(double from, double to) {
    return normalise(to - from);
  }
}
