package org.toqa.motion;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * A rectangle of the floor that is a robot's own as a whole for a while, to find its own way
 * through it; all of the robot stays inside.
 *
 * @param x metres, map frame, of its west side
 * @param y metres, map frame, of its south side
 * @param width metres to the east
 * @param height metres to the north
 * @param speed metres a second that the robot may drive in it at most
 * @param obstacles what the map shows in it
 */
public record FreeZone(
    double x, double y, double width, double height, double speed, List<Obstacle> obstacles) {

  /** Metres wider than a robot a zone is at least, to get by anything in it. */
  public static final double AIR = 0.3;

  /**
   * A circle round something that stands.
   *
   * @param x metres, map frame
   * @param y metres, map frame
   * @param radius metres
   */
  public record Obstacle(double x, double y, double radius) {
    public Vec2 centre() {
      return new Vec2(x, y);
    }
  }

  public FreeZone {
    obstacles = List.copyOf(obstacles);
  }

  /**
   * How far a disc is inside, metres; below 0: it reaches out.
   *
   * @param middle metres, map frame
   * @param radius metres
   */
  public double inside(Vec2 middle, double radius) {
    double across = Math.min(middle.x() - x, x + width - middle.x());
    double along = Math.min(middle.y() - y, y + height - middle.y());
    return Math.min(across, along) - radius;
  }
}
