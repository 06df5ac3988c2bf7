package org.toqa.arm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.toqa.geometry.Vec2;

/**
 * How the joints stand when the hand is at a place: in closed form, both elbows, a few sines.
 *
 * <p>Source: CMCT, "Manipulator", with its arcsine, its sum and its arctan(2 y/x) put right: that
 * the hand is there then is what {@link Arm#handAt} says.
 */
public final class InverseKinematics {

  /** Metres; a place that is farther out or in by less is on the edge. */
  private static final double SAME_PLACE = 1e-9;

  private InverseKinematics() {}

  /**
   * @param target metres, robot's frame; finite
   */
  public static Reach solve(Arm arm, Vec2 target) {
    Vec2 place = arm.inArmFrame(target);
    double distance = place.norm();
    if (!(distance <= arm.farthest() + SAME_PLACE)) {
      return new Reach.Outside(Reach.Reason.TOO_FAR, distance);
    }
    if (distance < arm.nearest() - SAME_PLACE) {
      return new Reach.Outside(Reach.Reason.TOO_NEAR, distance);
    }
    // cos t2 = (x^2 + y^2 - L1^2 - L2^2) / (2 L1 L2)
    double l1 = arm.upperLink();
    double l2 = arm.foreLink();
    double cosine = (distance * distance - l1 * l1 - l2 * l2) / (2 * l1 * l2);
    double bend = Math.acos(Math.clamp(cosine, -1, 1));
    List<JointAngles> ways = new ArrayList<>();
    allowedWay(arm, place, bend).ifPresent(ways::add);
    if (bend > JointLimits.SAME_ANGLE && Math.PI - bend > JointLimits.SAME_ANGLE) {
      allowedWay(arm, place, -bend).ifPresent(ways::add);
    }
    return ways.isEmpty()
        ? new Reach.Outside(Reach.Reason.JOINT_LIMITS, distance)
        : new Reach.Within(ways);
  }

  private static Optional<JointAngles> allowedWay(Arm arm, Vec2 place, double elbow) {
    // t1 = atan2(y, x) - atan2(L2 sin t2, L1 + L2 cos t2)
    double shoulder =
        place.angle()
            - Math.atan2(
                arm.foreLink() * Math.sin(elbow),
                arm.upperLink() + arm.foreLink() * Math.cos(elbow));
    return allowedTurn(arm.shoulder(), shoulder)
        .flatMap(s -> allowedTurn(arm.elbow(), elbow).map(e -> new JointAngles(s, e)));
  }

  /** The same direction with whole turns added, as the joint may stand; nearest to its middle. */
  private static Optional<Double> allowedTurn(JointLimits joint, double angle) {
    double middle = (joint.least() + joint.most()) / 2;
    double turned = angle - 2 * Math.PI * Math.rint((angle - middle) / (2 * Math.PI));
    return joint.allows(turned) ? Optional.of(joint.nearest(turned)) : Optional.empty();
  }
}
