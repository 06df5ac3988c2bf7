package org.toqa.lab.fouragents;

import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/** Geometry of convex outlines, by their corners counter-clockwise, and of discs. */
final class Outlines {
  private Outlines() {}

  static boolean contains(List<Vec2> corners, Vec2 point) {
    for (int i = 0; i < corners.size(); i++) {
      Vec2 from = corners.get(i);
      Vec2 edge = corners.get((i + 1) % corners.size()).minus(from);
      Vec2 to = point.minus(from);
      if (edge.x() * to.y() - edge.y() * to.x() < 0) {
        return false;
      }
    }
    return true;
  }

  /** Metres from a point to an outline; 0 inside. */
  static double distance(List<Vec2> corners, Vec2 point) {
    if (contains(corners, point)) {
      return 0;
    }
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < corners.size(); i++) {
      nearest =
          Math.min(
              nearest, point.distanceToLine(corners.get(i), corners.get((i + 1) % corners.size())));
    }
    return nearest;
  }

  /** Metres along a ray to a disc; at most {@code farthest}. */
  static double seen(Vec2 centre, double radius, Pose ray, double farthest) {
    Vec2 there = centre.minus(ray.position()).rotated(-ray.theta());
    double half = radius * radius - there.y() * there.y();
    if (half <= 0 || there.x() + Math.sqrt(half) < 0) {
      return farthest;
    }
    return Math.clamp(there.x() - Math.sqrt(half), 0, farthest);
  }
}
