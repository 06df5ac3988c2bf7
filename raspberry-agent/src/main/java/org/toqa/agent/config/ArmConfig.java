package org.toqa.agent.config;

import org.jspecify.annotations.Nullable;
import org.toqa.arm.Arm;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.geometry.Pose;

/**
 * The arm of a robot.
 *
 * @param boxWeight kilograms of what a simulated arm grasps; null: as was ordered
 */
public record ArmConfig(Arm arm, @Nullable Double boxWeight) {

  /**
   * @param top the whole content of the file
   * @return null: the robot has no arm
   */
  static @Nullable ArmConfig read(ConfigSection top) throws ConfigException {
    if (!top.has("arm")) {
      return null;
    }
    ConfigSection arm =
        top.section(
            "arm",
            "upperLink",
            "foreLink",
            "base",
            "maxLoad",
            "shoulder",
            "elbow",
            "rest",
            "boxWeight");
    JointLimits shoulder = joint(arm, "shoulder");
    JointLimits elbow = joint(arm, "elbow");
    ConfigSection base = arm.section("base", "x", "y", "heading");
    ConfigSection rest = arm.section("rest", "shoulder", "elbow");
    return new ArmConfig(
        new Arm(
            arm.number("upperLink", 0.3, 0.02, 10),
            arm.number("foreLink", 0.25, 0.02, 10),
            new Pose(
                base.number("x", 0.05, -5, 5),
                base.number("y", 0, -5, 5),
                Math.toRadians(base.number("heading", 0, -360, 360))),
            shoulder,
            elbow,
            arm.number("maxLoad", 2, 0.01, 1_000),
            new JointAngles(
                angle(rest, "shoulder", 120, shoulder), angle(rest, "elbow", -150, elbow))),
        arm.has("boxWeight") ? arm.number("boxWeight", 0, 0, 1_000) : null);
  }

  private static JointLimits joint(ConfigSection arm, String key) throws ConfigException {
    ConfigSection joint = arm.section(key, "least", "most", "maxRate", "maxAcceleration");
    double least = joint.number("least", -160, -360, 359);
    return new JointLimits(
        Math.toRadians(least),
        Math.toRadians(joint.number("most", Math.max(160, least + 1), least + 1, 360)),
        Math.toRadians(joint.number("maxRate", 90, 1, 720)),
        Math.toRadians(joint.number("maxAcceleration", 180, 1, 7_200)));
  }

  /** Of a joint at rest, within its limits. */
  private static double angle(ConfigSection rest, String key, double usual, JointLimits joint)
      throws ConfigException {
    double least = Math.toDegrees(joint.least());
    double most = Math.toDegrees(joint.most());
    return Math.toRadians(
        rest.number(key, Math.clamp(usual, least, most), rounded(least), rounded(most)));
  }

  /** Degrees as they were entered. */
  private static double rounded(double degrees) {
    return Math.rint(degrees * 1e6) / 1e6;
  }
}
