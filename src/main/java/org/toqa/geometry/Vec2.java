package org.toqa.geometry;

import java.util.List;

/**
 * A point or a displacement in the plane.
 *
 * @param x metres, to the east on a map, forward on a robot
 * @param y metres, to the north on a map, left on a robot
 */
public record Vec2(double x, double y) {

  public static final Vec2 ZERO = new Vec2(0, 0);

  /** The sum, in the same frame. */
  public Vec2 plus(Vec2 other) {
    return new Vec2(x + other.x, y + other.y);
  }

  /** The displacement from the other to this, in the same frame. */
  public Vec2 minus(Vec2 other) {
    return new Vec2(x - other.x, y - other.y);
  }

  /** The same direction, that many times as long; the opposite one below 0. */
  public Vec2 times(double factor) {
    return new Vec2(x * factor, y * factor);
  }

  /** Turned counter-clockwise by {@code angle} radians. */
  public Vec2 rotated(double angle) {
    double cos = Math.cos(angle);
    double sin = Math.sin(angle);
    return new Vec2(x * cos - y * sin, x * sin + y * cos);
  }

  /** Length in metres. */
  public double norm() {
    return Math.hypot(x, y);
  }

  /** Metres. */
  public double distanceTo(Vec2 other) {
    return Math.hypot(x - other.x, y - other.y);
  }

  /** Metres along the line through these points. */
  public static double lengthOf(List<Vec2> line) {
    double length = 0;
    for (int i = 1; i < line.size(); i++) {
      length += line.get(i - 1).distanceTo(line.get(i));
    }
    return length;
  }

  /** Metres from this point to the nearest one of the straight line between two others. */
  public double distanceToLine(Vec2 from, Vec2 to) {
    Vec2 along = to.minus(from);
    Vec2 here = minus(from);
    double squared = along.x * along.x + along.y * along.y;
    double t = squared == 0 ? 0 : (here.x * along.x + here.y * along.y) / squared;
    double east = here.x - along.x * Math.clamp(t, 0, 1);
    double north = here.y - along.y * Math.clamp(t, 0, 1);
    return Math.sqrt(east * east + north * north); // several times as fast as hypot
  }

  /** Metres between the nearest points of two straight lines, each between two points. */
  public static double distanceBetweenLines(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (isLeftAndRight(a, b, c, d) && isLeftAndRight(c, d, a, b)) {
      return 0;
    }
    return Math.min(
        Math.min(a.distanceToLine(c, d), b.distanceToLine(c, d)),
        Math.min(c.distanceToLine(a, b), d.distanceToLine(a, b)));
  }

  /** Whether one of two points is to the left of a line and the other to the right. */
  private static boolean isLeftAndRight(Vec2 from, Vec2 to, Vec2 one, Vec2 other) {
    return side(from, to, one) * side(from, to, other) < 0;
  }

  private static double side(Vec2 from, Vec2 to, Vec2 point) {
    return (to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x);
  }

  /** Direction in radians, counter-clockwise from +x, in (-pi, pi]; 0 for the zero vector. */
  public double angle() {
    return Math.atan2(y, x);
  }
}
