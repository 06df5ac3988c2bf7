package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.arm.ArmReading;
import org.toqa.motion.Odometry;
import org.toqa.motion.ThreeWheelKinematics;
import org.toqa.motion.Trajectory;
import org.toqa.motion.WheelLimits;

/** Numbers that are in the firmware's sources and in the daemon's. */
class FirmwareConstantsTest {

  private static final Path SOURCES = Path.of("firmware/src");
  private static final double TURN = 2 * Math.PI;

  @Test
  void bodyIsTheSame() throws IOException {
    ThreeWheelKinematics wheels = ThreeWheelKinematics.DEFAULT;
    assertEquals(wheels.wheelRadius(), constant("settings.h", "SETTINGS_WHEEL_RADIUS_UM") / 1e6);
    assertEquals(
        wheels.centreToWheel(), constant("settings.h", "SETTINGS_CENTRE_TO_WHEEL_UM") / 1e6);
    assertEquals(wheels.wheelCount(), constant("body.h", "BODY_WHEELS"));
    assertEquals(Odometry.COUNTS_PER_WHEEL_TURN, constant("body.h", "BODY_COUNTS_PER_TURN"));
  }

  @Test
  void settingsHaveTheSameBounds() throws IOException {
    assertSetting(FirmwareSettings.LEAST_WHEEL_RADIUS, "LEAST_WHEEL_RADIUS_UM", 1e6);
    assertSetting(FirmwareSettings.MOST_WHEEL_RADIUS, "MOST_WHEEL_RADIUS_UM", 1e6);
    assertSetting(FirmwareSettings.LEAST_CENTRE_TO_WHEEL, "LEAST_CENTRE_TO_WHEEL_UM", 1e6);
    assertSetting(FirmwareSettings.MOST_CENTRE_TO_WHEEL, "MOST_CENTRE_TO_WHEEL_UM", 1e6);
    assertSetting(FirmwareSettings.LEAST_FLOOR_VOLTS, "LEAST_FLOOR_MV", 1e3);
    assertSetting(FirmwareSettings.MOST_FLOOR_VOLTS, "MOST_FLOOR_MV", 1e3);
    assertSetting(FirmwareSettings.FLOOR_VOLTS, "FLOOR_MV", 1e3);
    assertEquals(FirmwareSettings.FLOOR_SENSORS, constant("body.h", "BODY_FLOOR_SENSORS"));
  }

  @Test
  void armHasTheSameBounds() throws IOException {
    String file = "arm_settings.h";
    assertEquals(ArmSettings.SHORTEST_PULSE, constant(file, "ARM_LEAST_PULSE_US"));
    assertEquals(ArmSettings.LONGEST_PULSE, constant(file, "ARM_MOST_PULSE_US"));
    assertEquals(ArmSettings.LEAST_PULSES_APART, constant(file, "ARM_LEAST_PULSES_US"));
    assertEquals(ArmSettings.MOST_VOLTS, constant(file, "ARM_MOST_MV") / 1e3);
    assertEquals(ArmSettings.LEAST_VOLTS_APART, constant(file, "ARM_LEAST_SPAN_MV") / 1e3);
    assertEquals(ArmSettings.LEAST_VOLTS_PER_KILOGRAM, constant(file, "ARM_LEAST_MV_A_KG") / 1e3);
    assertEquals(ArmSettings.MOST_RATE, constant(file, "ARM_MOST_RATE") / 1e3);
    assertEquals(ArmReading.LEAST_LOAD, constant("arm.h", "ARM_LEAST_LOAD_G") / 1e3);
    assertTrue(constant(file, "ARM_MOST_ANGLE_URAD") / 1e6 >= TURN);
  }

  private static void assertSetting(double expected, String name, double units) throws IOException {
    assertEquals(expected, constant("settings.h", "SETTINGS_" + name) / units, 1e-9);
  }

  @Test
  void wheelLimitsAreTheSame() throws IOException {
    WheelLimits limits = WheelLimits.DEFAULT;
    double rated = constant("body.h", "BODY_RATED_RPM") / 60 * TURN;
    double most = constant("body.h", "BODY_MAX_RPM") / 60 * TURN;
    assertEquals(limits.ratedRate(), rated, 1e-9);
    assertEquals(limits.maxRate(), most, 1e-9);
  }

  /** The simulated body turns its wheels up to the rated speed, the firmware less. */
  @Test
  void firmwareTurnsWheelsMoreSlowlyThanTheSimulatedBody() {
    WheelLimits limits = WheelLimits.DEFAULT;
    assertEquals(220 / 150.0, limits.ratedRate() / limits.maxRate(), 1e-9);
    // a rim of 0.04 m: 150 / 60 * 2 pi * 0.04 = 0.628 m/s
    assertEquals(0.628, limits.maxRate() * ThreeWheelKinematics.DEFAULT.wheelRadius(), 1e-3);
  }

  @Test
  void framesCarryTheSameRange() throws IOException {
    ChassisConfig body =
        new ChassisConfig.Spi(Path.of("/dev/null"), 0, 0, true, FirmwareSettings.DEFAULT);
    assertEquals(FrameCodec.MAX_SPEED, body.mostSpeed());
    assertEquals(FrameCodec.MAX_TURN_RATE, body.mostTurnRate());
    assertEquals(FrameCodec.MAX_SPEED, constant("twist.h", "TWIST_SPEED_LIMIT_UM_S") / 1e6);
    assertEquals(FrameCodec.MAX_TURN_RATE, constant("twist.h", "TWIST_TURN_LIMIT_URAD_S") / 1e6);
    assertEquals(FrameCodec.MAX_SEGMENT_SECONDS, constant("segment.h", "SEGMENT_LONGEST_US") / 1e6);
  }

  @Test
  void batteryIsEmptyAtTheSameVoltage() throws IOException {
    assertEquals(BatteryGauge.EMPTY_VOLTS, constant("battery.h", "BATTERY_LOW_MV") / 1e3);
  }

  @Test
  void pathIsDrivenAlike() throws IOException {
    PaceLimits daemon = PaceLimits.forSingleRobot(new MotionLimits(0.5, 3.5, 0.5, 3));
    assertEquals(daemon.speedJump(), constant("segment.c", "SPEED_JUMP_UM_S") / 1e6);
    assertEquals(daemon.turnRateJump(), constant("segment.c", "TURN_JUMP_URAD_S") / 1e6);
    assertEquals(Chassis.QUEUE_LENGTH, constant("segment.h", "SEGMENT_QUEUE_LENGTH"));
    assertEquals(FrameCodec.MIN_ACCELERATION, constant("segment.h", "SEGMENT_LEAST_RATE") / 1e3);
    assertEquals(Trajectory.MAX_DEVIATION, constant("segment_runner.c", "WAITING_UM") / 1e6, 1e-9);
  }

  /** The value of {@code #define NAME value}, or of {@code NAME = value}; products are computed. */
  private static double constant(String file, String name) throws IOException {
    String source = Files.readString(SOURCES.resolve(file));
    Matcher found =
        Pattern.compile("\\b" + name + "(?: =)? +\\(?(?:U?INT32_C\\()?([0-9 *]+)").matcher(source);
    assertTrue(found.find(), name + " in " + file);
    return Pattern.compile("[0-9]+")
        .matcher(found.group(1))
        .results()
        .map(MatchResult::group)
        .mapToDouble(Double::parseDouble)
        .reduce(1, (a, b) -> a * b);
  }
}
