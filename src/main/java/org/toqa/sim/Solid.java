package org.toqa.sim;

import org.toqa.geometry.Pose;

/** Something round that stands or moves on a floor. Any thread sees where it was last put. */
final class Solid {
  private final double radius;
  private volatile Pose at;

  /**
   * @param at its middle, map frame
   * @param radius metres
   */
  Solid(Pose at, double radius) {
    this.at = at;
    this.radius = radius;
  }

  Pose at() {
    return at;
  }

  double radius() {
    return radius;
  }

  void moveTo(Pose place) {
    at = place;
  }

  /** Metres along a ray until it meets it; beyond {@code farthest} anything above that. */
  double distance(Pose ray, double farthest) {
    Pose middle = at;
    double x = middle.x() - ray.x();
    double y = middle.y() - ray.y();
    double reach = farthest + radius;
    if (Math.abs(x) > reach || Math.abs(y) > reach) {
      return Double.POSITIVE_INFINITY;
    }
    double cos = Math.cos(ray.theta());
    double sin = Math.sin(ray.theta());
    double along = x * cos + y * sin;
    double aside = y * cos - x * sin;
    double half = radius * radius - aside * aside;
    if (half <= 0 || along + Math.sqrt(half) < 0) {
      return Double.POSITIVE_INFINITY;
    }
    return Math.max(0, along - Math.sqrt(half));
  }
}
