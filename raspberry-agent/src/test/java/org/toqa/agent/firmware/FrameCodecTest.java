package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.toqa.agent.firmware.ArmSettings.JointWiring;
import org.toqa.agent.firmware.FirmwareCommand.ArmMeasures;
import org.toqa.agent.firmware.FirmwareCommand.ArmMove;
import org.toqa.agent.firmware.FirmwareCommand.ArmPoll;
import org.toqa.agent.firmware.FirmwareCommand.Caption;
import org.toqa.agent.firmware.FirmwareCommand.Clear;
import org.toqa.agent.firmware.FirmwareCommand.Path;
import org.toqa.agent.firmware.FirmwareCommand.Poll;
import org.toqa.agent.firmware.FirmwareCommand.Segments;
import org.toqa.agent.firmware.FirmwareCommand.Settings;
import org.toqa.agent.firmware.FirmwareCommand.Velocity;
import org.toqa.arm.Arm;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.Segment;
import org.toqa.motion.ThreeWheelKinematics;

/** The golden frames, which the firmware's own tests read too. */
class FrameCodecTest {

  static Stream<GoldenFrame> commands() throws IOException {
    return GoldenFrame.all().filter(g -> !g.kind().endsWith("status") && !g.kind().equals("bad"));
  }

  static Stream<GoldenFrame> statuses() throws IOException {
    return GoldenFrame.all().filter(g -> g.kind().equals("status"));
  }

  static Stream<GoldenFrame> bad() throws IOException {
    return GoldenFrame.all().filter(g -> g.kind().equals("bad"));
  }

  @ParameterizedTest
  @MethodSource("commands")
  void commandBecomesItsGoldenFrame(GoldenFrame golden) {
    FirmwareCommand command =
        switch (golden.kind()) {
          case "poll" -> new Poll();
          case "velocity" ->
              new Velocity(
                  new Twist(
                      golden.millionths("vx_um_s"),
                      golden.millionths("vy_um_s"),
                      golden.millionths("w_urad_s")));
          case "path" ->
              new Path(
                  (int) golden.number("number"),
                  new Pose(
                      golden.millionths("x_um"),
                      golden.millionths("y_um"),
                      golden.millionths("heading_urad")),
                  golden.number("pace_q15") / 32_768.0,
                  golden.number("acceleration_mm_s2") / 1e3,
                  golden.number("turn_acceleration_mrad_s2") / 1e3,
                  golden.number("onward") == 1,
                  segments(golden));
          case "segments" ->
              new Segments(
                  (int) golden.number("path"),
                  (int) golden.number("first"),
                  golden.number("onward") == 1,
                  segments(golden));
          case "clear" ->
              new Clear(
                  StopReason.ofBits((int) golden.number("reasons")), golden.number("by") == 1);
          case "settings" ->
              new Settings(
                  new FirmwareSettings(
                      new ThreeWheelKinematics(
                          golden.millionths("wheel_radius_um"),
                          golden.millionths("centre_to_wheel_um")),
                      IntStream.rangeClosed(1, FirmwareSettings.FLOOR_SENSORS)
                          .mapToObj(i -> golden.number("floor" + i + "_mv") / 1e3)
                          .toList()));
          case "arm_settings" -> new ArmMeasures(armSettings(golden));
          case "arm_move" ->
              new ArmMove(
                  new JointAngles(
                      golden.millionths("shoulder_urad"), golden.millionths("elbow_urad")),
                  golden.number("closed") == 1,
                  golden.number("onward") == 1);
          case "arm_poll" -> new ArmPoll();
          case "caption" -> new Caption(golden.text("text"));
          default -> throw new IllegalArgumentException("What is a " + golden.kind() + "?");
        };

    assertArrayEquals(golden.frame(), FrameCodec.encode(command, (int) golden.number("sequence")));
  }

  private static ArmSettings armSettings(GoldenFrame golden) {
    JointLimits shoulder = limits(golden, "shoulder_");
    JointLimits elbow = limits(golden, "elbow_");
    return new ArmSettings(
        new Arm(
            0.3,
            0.25,
            new Pose(0, 0, 0),
            shoulder,
            elbow,
            2,
            new JointAngles(shoulder.least(), elbow.least())),
        wiring(golden, "shoulder_"),
        wiring(golden, "elbow_"),
        golden.number("open_us"),
        golden.number("closed_us"),
        golden.number("empty_mv") / 1e3,
        golden.number("mv_a_kg") / 1e3);
  }

  private static JointLimits limits(GoldenFrame golden, String joint) {
    return new JointLimits(
        golden.millionths(joint + "least_urad"),
        golden.millionths(joint + "most_urad"),
        golden.number(joint + "rate_mrad_s") / 1e3,
        golden.number(joint + "acceleration_mrad_s2") / 1e3);
  }

  private static JointWiring wiring(GoldenFrame golden, String joint) {
    return new JointWiring(
        golden.number(joint + "pulse_least_us"),
        golden.number(joint + "pulse_most_us"),
        golden.number(joint + "mv_least") / 1e3,
        golden.number(joint + "mv_most") / 1e3);
  }

  static Stream<GoldenFrame> armStatuses() throws IOException {
    return GoldenFrame.all().filter(g -> g.kind().equals("arm_status"));
  }

  @ParameterizedTest
  @MethodSource("armStatuses")
  void goldenFrameBecomesItsStatusOfTheArm(GoldenFrame golden) {
    assertTrue(FrameCodec.decode(golden.frame()).isEmpty());
    assertEquals(
        new ArmStatus(
            ArmStatus.State.values()[(int) golden.number("arm")],
            golden.number("closed") == 1,
            new JointAngles(golden.millionths("shoulder_urad"), golden.millionths("elbow_urad")),
            new JointAngles(
                golden.millionths("shoulder_goal_urad"), golden.millionths("elbow_goal_urad")),
            golden.number("load_g") / 1e3,
            golden.number("progress") / 255.0),
        FrameCodec.decodeArm(golden.frame()).orElseThrow());
  }

  private static List<Segment> segments(GoldenFrame golden) {
    return IntStream.rangeClosed(1, (int) golden.number("count"))
        .mapToObj(
            i ->
                new Segment(
                    golden.millionths("v" + i + "_um_s"),
                    golden.millionths("w" + i + "_urad_s"),
                    golden.millionths("t" + i + "_us")))
        .toList();
  }

  @ParameterizedTest
  @MethodSource("statuses")
  void goldenFrameBecomesItsStatus(GoldenFrame golden) {
    FirmwareStatus status = FrameCodec.decode(golden.frame()).orElseThrow();

    assertEquals(golden.number("sequence"), status.sequence());
    assertEquals(golden.number("answer"), status.answer().ordinal());
    assertEquals(golden.number("state"), status.state().ordinal());
    assertEquals(golden.number("reasons"), StopReason.bits(status.stopReasons()));
    assertEquals(golden.number("power_cycle"), status.powerCycle());
    assertEquals(golden.number("stamp_ms"), status.stampMillis());
    for (int wheel = 1; wheel <= 3; wheel++) {
      assertEquals(golden.number("count" + wheel), status.counts().get(wheel - 1).longValue());
    }
    assertEquals(golden.millionths("x_um"), status.odometry().x(), 1e-9);
    assertEquals(golden.millionths("y_um"), status.odometry().y(), 1e-9);
    assertEquals(0, Math.sin(golden.millionths("heading_urad") - status.odometry().theta()), 1e-9);
    assertEquals(golden.number("battery_mv") / 1e3, status.batteryVolts(), 1e-9);
    assertEquals(golden.number("floor"), status.missingFloor());
    assertEquals(golden.number("switches"), status.pressedSwitches());
    assertEquals(golden.number("temperature"), status.temperature());
    assertEquals(golden.number("queue_free"), status.freeSegments());
    assertEquals(golden.number("segments"), status.segmentsDriven());
    assertEquals(golden.number("covered_us") / 1e6, status.coveredSeconds(), 1e-9);
    assertEquals(golden.number("pace") / 255.0, status.pace(), 1e-9);
    assertEquals(golden.number("path"), status.path());
    assertEquals(golden.number("bad"), status.badFrames());
    assertEquals(golden.number("lost"), status.lostBytes());
  }

  @Test
  void rangesAreThereAllOrNone() throws IOException {
    List<List<Double>> ranges =
        statuses().map(g -> FrameCodec.decode(g.frame()).orElseThrow().ranges()).toList();

    assertEquals(List.of(List.of(), List.of(0.1, 0.345, 0.8), List.of()), ranges);
  }

  @ParameterizedTest
  @MethodSource("bad")
  void badFrameIsNoStatus(GoldenFrame golden) {
    assertTrue(FrameCodec.decode(golden.frame()).isEmpty());
    assertTrue(FrameCodec.decodeArm(golden.frame()).isEmpty());
  }

  @Test
  void everyFlippedBitOfAStatusIsNoticed() throws IOException {
    byte[] frame = statuses().findFirst().orElseThrow().frame();
    for (int bit = 0; bit < 8 * FrameCodec.LENGTH; bit++) {
      byte[] damaged = frame.clone();
      damaged[bit / 8] ^= (byte) (1 << bit % 8);
      assertTrue(FrameCodec.decode(damaged).isEmpty(), "bit " + bit);
    }
  }

  @Test
  void whatTheMicrocontrollerDoesNotTakeIsCut() {
    assertArrayEquals(
        FrameCodec.encode(new Velocity(new Twist(1, -1, 10)), 3),
        FrameCodec.encode(new Velocity(new Twist(7, -7, 70)), 3));
    assertArrayEquals(
        FrameCodec.encode(new Caption("r1 10.0.0.1         "), 3),
        FrameCodec.encode(new Caption("r1 10.0.0.1"), 3));
    assertArrayEquals(
        FrameCodec.encode(new Caption("a?b"), 3), FrameCodec.encode(new Caption("a\nb"), 3));
  }
}
