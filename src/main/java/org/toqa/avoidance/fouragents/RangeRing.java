package org.toqa.avoidance.fouragents;

import java.util.List;
import org.toqa.geometry.Pose;

/**
 * Eight range sensors on the rim of a round robot, in the order of the Khepera II: from the left
 * over the front to the right, then the two behind. Six look ahead and aside; the exact angles are
 * of its manual's drawing, since the seed's figure is lost.
 *
 * @param radius of the robot, metres
 * @param farthest metres from the rim; the reading of a sensor that sees nothing
 */
public record RangeRing(double radius, double farthest) {

  /** Radians from the heading, counter-clockwise. */
  static final List<Double> DIRECTIONS =
      List.of(
          Math.toRadians(90),
          Math.toRadians(45),
          Math.toRadians(10),
          Math.toRadians(-10),
          Math.toRadians(-45),
          Math.toRadians(-90),
          Math.toRadians(-160),
          Math.toRadians(160));

  /** How many sensors there are. */
  public static final int SIZE = DIRECTIONS.size();

  /** Where each sensor is and looks, robot frame. */
  public List<Pose> beams() {
    return DIRECTIONS.stream()
        .map(d -> new Pose(radius * Math.cos(d), radius * Math.sin(d), d))
        .toList();
  }
}
