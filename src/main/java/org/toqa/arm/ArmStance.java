package org.toqa.arm;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * How a robot faces where it stands, so that its arm comes to a place: of all headings, degree by
 * degree, the one with which the place is nearest to straight ahead of it.
 */
public sealed interface ArmStance {

  /**
   * @param heading radians, counter-clockwise from map east
   */
  record Facing(double heading) implements ArmStance {}

  /**
   * No heading helps.
   *
   * @param distance metres from the shoulder to the place, for the heading that comes nearest
   */
  record None(Reach.Reason reason, double distance) implements ArmStance {}

  /**
   * @param stand where the robot's centre is, metres, map frame
   * @param target where the hand shall come, metres, map frame
   */
  static ArmStance find(Arm arm, Vec2 stand, Vec2 target) {
    Vec2 offset = target.minus(stand);
    double bearing = offset.angle();
    Reach.@Nullable Outside nearest = null;
    for (int k = 0; k < 360; k++) { // 0, 1, -1, 2, -2 to 180 degrees from straight ahead
      double aside = Math.toRadians(k % 2 == 0 ? -(k / 2) : k / 2 + 1);
      Reach reach = InverseKinematics.solve(arm, new Vec2(offset.norm(), 0).rotated(aside));
      if (!(reach instanceof Reach.Outside out)) {
        return new Facing(new Pose(0, 0, bearing - aside).theta());
      }
      nearest = nearest == null || isNearer(arm, out, nearest) ? out : nearest;
    }
    if (nearest == null) {
      throw new IllegalStateException("no heading was tried");
    }
    return new None(nearest.reason(), nearest.distance());
  }

  private static boolean isNearer(Arm arm, Reach.Outside one, Reach.Outside other) {
    return missing(arm, one) < missing(arm, other);
  }

  /** Metres that the hand is short of the place. */
  private static double missing(Arm arm, Reach.Outside out) {
    return switch (out.reason()) {
      case TOO_FAR -> out.distance() - arm.farthest();
      case TOO_NEAR -> arm.nearest() - out.distance();
      case JOINT_LIMITS -> 0;
    };
  }
}
