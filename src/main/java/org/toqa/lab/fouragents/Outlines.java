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

  /** Metres along a ray to an outline; at most {@code farthest}. */
  static double seen(List<Vec2> corners, Pose ray, double farthest) {
    double cos = Math.cos(ray.theta());
    double sin = Math.sin(ray.theta());
    double nearest = farthest;
    for (int i = 0; i < corners.size(); i++) {
      Vec2 a = corners.get(i);
      Vec2 b = corners.get((i + 1) % corners.size());
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
