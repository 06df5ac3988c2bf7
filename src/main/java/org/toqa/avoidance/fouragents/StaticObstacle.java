package org.toqa.avoidance.fouragents;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * A known obstacle that stands: the circle round it.
 *
 * @param centre metres, map frame
 * @param radius metres
 */
public record StaticObstacle(Vec2 centre, double radius) {

  /**
   * A convex obstacle.
   *
   * @param corners metres, map frame, at least one; the circle is about their mean
   */
  public static StaticObstacle around(List<Vec2> corners) {
    Vec2 centre = corners.stream().reduce(Vec2.ZERO, Vec2::plus).times(1.0 / corners.size());
    double radius = corners.stream().mapToDouble(centre::distanceTo).max().orElseThrow();
    return new StaticObstacle(centre, radius);
  }
}
