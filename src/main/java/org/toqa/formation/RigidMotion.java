package org.toqa.formation;

import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/** How the points of a shape move that turns with its leader. */
final class RigidMotion {

  private RigidMotion() {}

  /**
   * @param leader in the leader's own frame
   * @param offset of the point, in the leader's frame
   * @return the point's velocity, in the leader's frame
   */
  // v_p = v + w x p
  static Twist at(Vec2 offset, Twist leader) {
    return new Twist(
        leader.vx() - leader.w() * offset.y(), leader.vy() + leader.w() * offset.x(), leader.w());
  }
}
