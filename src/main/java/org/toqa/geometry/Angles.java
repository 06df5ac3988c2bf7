package org.toqa.geometry;

/** Arithmetic of angles in radians, counter-clockwise. */
public final class Angles {
  private Angles() {}

  /** The same direction in (-pi, pi]. */
  public static double normalise(double angle) {
    double turned = angle - 2 * Math.PI * Math.floor((angle + Math.PI) / (2 * Math.PI));
    return turned <= -Math.PI ? turned + 2 * Math.PI : turned;
  }

  /** The turn that leads from one direction to the other, in (-pi, pi]. */
  public static double difference(double from, double to) {
    return normalise(to - from);
  }
}
