package org.toqa.planning.smooth;

import org.toqa.geometry.Vec2;

/**
 * Moves a point that is too near to a wall away from it, to where the walls on both sides are
 * equally far (Wilmarth, Amato and Stiller, "MAPRM", 1999). So narrow passages are met as often as
 * their surroundings are wide: a passage that just fits has no area, but what is moved into it has.
 */
final class Retraction {
  /** How often the span in which the middle lies is cut: to less than a millionth of it. */
  private static final int CUTS = 30;

  private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

  private final DiscSpace space;
  private double x;
  private double y;

  Retraction(DiscSpace space) {
    this.space = space;
  }

  /**
   * Moves a point, cells.
   *
   * @return whether it is free then
   */
  boolean retract(double fromX, double fromY) {
    Vec2 wall = space.nearestWall(fromX, fromY);
    double distance = space.distance(fromX, fromY);
    if (wall == null || distance == 0) {
      return false;
    }
    double radius = space.radiusInCells();
    double awayX = (fromX - wall.x()) / distance;
    double awayY = (fromY - wall.y()) / distance;
    if (isFree(wall, awayX, awayY, 2 * radius)) {
      // there is room: to where it is just free, with a little more
      return isFree(wall, awayX, awayY, 1.001 * radius);
    }
    double near = distance;
    double far = 2 * radius;
    for (int i = 0; i < CUTS; i++) {
      double lower = far - GOLDEN * (far - near);
      double upper = near + GOLDEN * (far - near);
      if (clearance(wall, awayX, awayY, lower) < clearance(wall, awayX, awayY, upper)) {
        near = lower;
      } else {
        far = upper;
      }
    }
    return isFree(wall, awayX, awayY, (near + far) / 2);
  }

  private double clearance(Vec2 wall, double awayX, double awayY, double distance) {
    return space.distance(wall.x() + distance * awayX, wall.y() + distance * awayY);
  }

  private boolean isFree(Vec2 wall, double awayX, double awayY, double distance) {
    x = wall.x() + distance * awayX;
    y = wall.y() + distance * awayY;
    return space.isFree(x, y);
  }

  /** Of the point moved last, cells. */
  double x() {
    return x;
  }

  /** Of the point moved last, cells. */
  double y() {
    return y;
  }
}
