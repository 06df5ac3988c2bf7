package org.toqa.geometry;

/**
 * A velocity in the moving body's own frame.
 *
 * @param vx metres a second, forward
 * @param vy metres a second, to the left
 * @param w radians a second, counter-clockwise
 */
public record Twist(double vx, double vy, double w) {

  public static final Twist ZERO = new Twist(0, 0, 0);

  /** The same motion, that many times as fast; backward below 0. */
  public Twist times(double factor) {
    return new Twist(vx * factor, vy * factor, w * factor);
  }
}
