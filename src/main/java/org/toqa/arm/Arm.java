package org.toqa.arm;

import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * What an arm of two links is: it turns in the plane of the floor, and its hand is at the end of
 * the fore link.
 *
 * @param upperLink metres from shoulder to elbow, more than 0
 * @param foreLink metres from elbow to hand, more than 0
 * @param base where the shoulder is and whither its angle 0 points, in the robot's frame: x
 *     forward, y left
 * @param maxLoad kilograms that the hand lifts, more than 0
 * @param rest how it stands while the robot drives
 */
public record Arm(
    double upperLink,
    double foreLink,
    Pose base,
    JointLimits shoulder,
    JointLimits elbow,
    double maxLoad,
    JointAngles rest) {

  /** Metres. */
  private static final double LONGEST_LINK = 10;

  public Arm {
    if (!isLength(upperLink) || !isLength(foreLink)) {
      throw new IllegalArgumentException("an arm's links are longer than 0 m, at most 10 m");
    }
    if (!(base.position().norm() <= LONGEST_LINK)) {
      throw new IllegalArgumentException("an arm's base is within 10 m of its robot's centre");
    }
    if (!(maxLoad > 0 && Double.isFinite(maxLoad))) {
      throw new IllegalArgumentException("an arm lifts more than 0 kg");
    }
    if (!shoulder.allows(rest.shoulder()) || !elbow.allows(rest.elbow())) {
      throw new IllegalArgumentException("an arm's rest is within the limits of its joints");
    }
  }

  private static boolean isLength(double link) {
    return link > 0 && link <= LONGEST_LINK;
  }

  /** Metres from the shoulder: the hand comes no farther. */
  public double farthest() {
    return upperLink + foreLink;
  }

  /** Metres from the shoulder: the hand comes no nearer. */
  public double nearest() {
    return Math.abs(upperLink - foreLink);
  }

  public boolean allows(JointAngles angles) {
    return shoulder.allows(angles.shoulder()) && elbow.allows(angles.elbow());
  }

  /** Where the elbow is, metres, robot's frame. */
  public Vec2 elbowAt(JointAngles angles) {
    return inRobotFrame(new Vec2(upperLink, 0).rotated(angles.shoulder()));
  }

  /** Where the hand is, metres, robot's frame. */
  public Vec2 handAt(JointAngles angles) {
    // x = L1 cos t1 + L2 cos(t1 + t2), y = L1 sin t1 + L2 sin(t1 + t2)
    return inRobotFrame(
        new Vec2(upperLink, 0)
            .rotated(angles.shoulder())
            .plus(new Vec2(foreLink, 0).rotated(angles.shoulder() + angles.elbow())));
  }

  private Vec2 inRobotFrame(Vec2 inArmFrame) {
    return base.compose(new Pose(inArmFrame.x(), inArmFrame.y(), 0)).position();
  }

  /** A place of the robot's frame in the arm's, metres. */
  Vec2 inArmFrame(Vec2 inRobotFrame) {
    return base.relative(new Pose(inRobotFrame.x(), inRobotFrame.y(), 0)).position();
  }
}
