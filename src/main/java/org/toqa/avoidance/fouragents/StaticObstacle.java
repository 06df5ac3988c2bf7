package org.toqa.avoidance.fouragents;

import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * A known obstacle that stands: the circle round it, and its outline where that is known.
 *
 * @param centre metres, map frame
 * @param radius metres
 * @param outline its corners counter-clockwise, metres, map frame; empty where only the circle is
 *     known
 */
public record StaticObstacle(Vec2 centre, double radius, List<Vec2> outline) {

  public StaticObstacle {
    outline = List.copyOf(outline);
  }

  /** One of which only the circle is known. */
  public StaticObstacle(Vec2 centre, double radius) {
    this(centre, radius, List.of());
  }

  /**
   * A convex obstacle.
   *
   * @param corners metres, map frame, at least one; the circle is about their mean
   */
  public static StaticObstacle around(List<Vec2> corners) {
    Vec2 centre = corners.stream().reduce(Vec2.ZERO, Vec2::plus).times(1.0 / corners.size());
    double radius = corners.stream().mapToDouble(centre::distanceTo).max().orElseThrow();
    return new StaticObstacle(centre, radius, corners);
  }

  /**
   * Metres along a ray to the outline.
   *
   * @param farthest metres; the answer where nothing is nearer
   */
  public double range(Pose ray, double farthest) {
    double cos = Math.cos(ray.theta());
    double sin = Math.sin(ray.theta());
    double nearest = farthest;
    for (int i = 0; i < outline.size(); i++) {
      Vec2 a = outline.get(i);
      Vec2 b = outline.get((i + 1) % outline.size());
      // in the ray's frame: where does the edge cross its line?
      double ay = (a.y() - ray.y()) * cos - (a.x() - ray.x()) * sin;
      double by = (b.y() - ray.y()) * cos - (b.x() - ray.x()) * sin;
      if (ay * by <= 0 && ay != by) {
        double ax = (a.x() - ray.x()) * cos + (a.y() - ray.y()) * sin;
        double bx = (b.x() - ray.x()) * cos + (b.y() - ray.y()) * sin;
        double along = ax + (bx - ax) * ay / (ay - by);
        if (along >= 0) {
          nearest = Math.min(nearest, along);
        }
      }
    }
    return nearest;
  }

  /** Whether a point is in the circle, or beside it by less than a tolerance. */
  boolean contains(Vec2 point, double tolerance) {
    return centre.distanceTo(point) <= radius + tolerance;
  }
}
