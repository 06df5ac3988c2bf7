package org.toqa.agent.config;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.firmware.ArmSettings;
import org.toqa.agent.firmware.ArmSettings.JointWiring;
import org.toqa.arm.Arm;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.geometry.Pose;

/**
 * The arm of a robot.
 *
 * @param settings what it is, and how it is wired to a microcontroller
 * @param boxWeight kilograms of what a simulated arm grasps; null: as was ordered
 */
public record ArmConfig(ArmSettings settings, @Nullable Double boxWeight) {

  /** One that is wired as usual. */
  public ArmConfig(Arm arm, @Nullable Double boxWeight) {
    this(ArmSettings.of(arm), boxWeight);
  }

  public Arm arm() {
    return settings.arm();
  }

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
            "hand",
            "loadSensor",
            "boxWeight");
    JointLimits shoulder = joint(arm, "shoulder");
    JointLimits elbow = joint(arm, "elbow");
    ConfigSection base = arm.section("base", "x", "y", "heading");
    ConfigSection rest = arm.section("rest", "shoulder", "elbow");
    Arm measures =
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
                angle(rest, "shoulder", 120, shoulder), angle(rest, "elbow", -150, elbow)));
    return new ArmConfig(
        settings(arm, measures),
        arm.has("boxWeight") ? arm.number("boxWeight", 0, 0, 1_000) : null);
  }

  private static ArmSettings settings(ConfigSection arm, Arm measures) throws ConfigException {
    ArmSettings usual = ArmSettings.of(measures);
    ConfigSection hand = arm.section("hand", "openPulse", "closedPulse");
    ConfigSection sensor = arm.section("loadSensor", "emptyVolts", "voltsPerKilogram");
    return new ArmSettings(
        measures,
        wiring(arm, "shoulder"),
        wiring(arm, "elbow"),
        pulse(hand, "openPulse", usual.openPulse()),
        pulse(hand, "closedPulse", usual.closedPulse()),
        sensor.number("emptyVolts", usual.emptyVolts(), 0, ArmSettings.MOST_VOLTS),
        sensor.number(
            "voltsPerKilogram",
            usual.voltsPerKilogram(),
            ArmSettings.LEAST_VOLTS_PER_KILOGRAM,
            ArmSettings.MOST_VOLTS));
  }

  private static double pulse(ConfigSection section, String key, double usual)
      throws ConfigException {
    return section.number(key, usual, ArmSettings.SHORTEST_PULSE, ArmSettings.LONGEST_PULSE);
  }

  private static JointWiring wiring(ConfigSection arm, String key) throws ConfigException {
    ConfigSection joint = jointSection(arm, key);
    JointWiring usual = JointWiring.DEFAULT;
    List<Double> pulses =
        apart(
            joint,
            "pulses",
            List.of(usual.leastPulse(), usual.mostPulse()),
            ArmSettings.SHORTEST_PULSE,
            ArmSettings.LONGEST_PULSE,
            ArmSettings.LEAST_PULSES_APART);
    List<Double> volts =
        apart(
            joint,
            "volts",
            List.of(usual.leastVolts(), usual.mostVolts()),
            0,
            ArmSettings.MOST_VOLTS,
            ArmSettings.LEAST_VOLTS_APART);
    return new JointWiring(pulses.getFirst(), pulses.getLast(), volts.getFirst(), volts.getLast());
  }

  /** Two numbers, at the joint's least angle and at its greatest, either way round. */
  private static List<Double> apart(
      ConfigSection joint, String key, List<Double> usual, double least, double most, double apart)
      throws ConfigException {
    List<Double> two = joint.numbers(key, usual, least, most);
    if (Math.abs(two.getFirst() - two.getLast()) < apart) {
      throw joint.invalid(key, two, "two numbers at least %s apart".formatted(apart));
    }
    return two;
  }

  private static JointLimits joint(ConfigSection arm, String key) throws ConfigException {
    ConfigSection joint = jointSection(arm, key);
    double least = joint.number("least", -160, -360, 359);
    return new JointLimits(
        Math.toRadians(least),
        Math.toRadians(joint.number("most", Math.max(160, least + 1), least + 1, 360)),
        Math.toRadians(joint.number("maxRate", 90, 1, 720)),
        Math.toRadians(joint.number("maxAcceleration", 180, 1, 7_200)));
  }

  private static ConfigSection jointSection(ConfigSection arm, String key) throws ConfigException {
    return arm.section(key, "least", "most", "maxRate", "maxAcceleration", "pulses", "volts");
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
