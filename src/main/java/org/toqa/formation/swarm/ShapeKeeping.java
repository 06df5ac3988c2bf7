package org.toqa.formation.swarm;

import org.toqa.geometry.Vec2;

/**
 * What the published law lacks: each robot drives back to its place in the shape, and keeps its own
 * clearance from what is beside it. The published law drives all robots alike, so what noise does
 * to the shape stays for ever.
 *
 * @param gain part of the distance to the place that is made good in a step, 0 to 1
 * @param most of the correction, a part of the swarm's speed; a push is at most twice that
 * @param clearance metres from the robot's rim: what is nearer pushes it away
 */
public record ShapeKeeping(double gain, double most, double clearance) {

  /** None: the published law. */
  public static final ShapeKeeping NONE = new ShapeKeeping(0, 0, 0);

  /**
   * A robot's displacement in a step.
   *
   * @param robot where it is and should be
   * @param leader the virtual leader, metres, map frame
   * @param forward the swarm's displacement in the step, metres, map frame
   * @param toNearest from the robot's rim to the nearest thing that its own sensor sees, metres,
   *     map frame; of length 0 or beyond the clearance: nothing
   */
  public Vec2 displacement(SwarmRobot robot, Vec2 leader, Vec2 forward, Vec2 toNearest) {
    double limit = most * forward.norm();
    // d = f + sat(k (L + q - x)) - 2 limit (1 - gap / clearance) n
    Vec2 back = limited(leader.plus(robot.wanted()).minus(robot.position()).times(gain), limit);
    double gap = toNearest.norm();
    boolean isNear = gap > 0 && gap < clearance;
    Vec2 away = isNear ? toNearest.times(-2 * limit * (1 - gap / clearance) / gap) : Vec2.ZERO;
    return forward.plus(back).plus(away);
  }

  private static Vec2 limited(Vec2 vector, double most) {
    double norm = vector.norm();
    return norm <= most ? vector : vector.times(most / norm);
  }
}
