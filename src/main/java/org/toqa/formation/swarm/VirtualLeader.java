package org.toqa.formation.swarm;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * The leader that no robot is: where it would be, on average, by where each robot is and should be.
 * It moves on smoothly when a robot is lost: with all in their places each one tells the same
 * point.
 */
public final class VirtualLeader {
  private VirtualLeader() {}

  /**
   * Where it is.
   *
   * @param robots at least one
   * @return metres, map frame
   * @throws IllegalArgumentException if there is no robot
   */
  public static Vec2 position(List<SwarmRobot> robots) {
    if (robots.isEmpty()) {
      throw new IllegalArgumentException("A swarm without robots has no virtual leader.");
    }
    // xL = sum (xi - xi_des) / N,  yL = sum (yi - yi_des) / N   (eq. 2, 3)
    Vec2 sum = Vec2.ZERO;
    for (SwarmRobot robot : robots) {
      sum = sum.plus(robot.position().minus(robot.wanted()));
    }
    return sum.times(1.0 / robots.size());
  }

  /**
   * How far the robots are from their places: the root of the mean square, metres.
   *
   * @param robots at least one
   */
  public static double shapeError(List<SwarmRobot> robots) {
    Vec2 leader = position(robots);
    double sum = 0;
    for (SwarmRobot robot : robots) {
      double off = robot.position().distanceTo(leader.plus(robot.wanted()));
      sum += off * off;
    }
    return Math.sqrt(sum / robots.size());
  }

  /**
   * A point in the frame of the moving swarm: x' ahead, y' left.
   *
   * @param point metres, map frame
   * @param leader metres, map frame
   * @param direction o, of motion, radians, counter-clockwise from map east
   */
  static Vec2 inFrame(Vec2 point, Vec2 leader, double direction) {
    // x' = (x - xL) cos o + (y - yL) sin o,  y' = (y - yL) cos o - (x - xL) sin o   (eq. 4, 5)
    return point.minus(leader).rotated(-direction);
  }
}
