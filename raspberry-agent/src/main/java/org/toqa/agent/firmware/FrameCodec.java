package org.toqa.agent.firmware;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
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
import org.toqa.agent.firmware.FirmwareStatus.Answer;
import org.toqa.agent.firmware.FirmwareStatus.State;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.avoidance.RangeSensors;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;

/** Commands to frames, and frames to statuses, as {@code docs/spi-frame.md} has them. */
public final class FrameCodec {

  /** Bytes of every frame. */
  public static final int LENGTH = 64;

  /** Sequences count from 0 to one less than this. */
  static final int SEQUENCES = 256;

  private static final short SYNC = 0x5AA5;
  private static final int CRC_OFFSET = 62;
  private static final int STATUS_KIND = 0x80;
  private static final int ARM_STATUS_KIND = 0x81;

  /** What a range sensor that sees nothing tells; more than this is no distance. */
  private static final int FARTHEST_MILLIMETRES = (int) Math.round(1_000 * RangeSensors.FARTHEST);

  private static final int FLOOR_BITS = (1 << FirmwareSettings.FLOOR_SENSORS) - 1;
  private static final int CAPTION_LENGTH = 20;

  /** What the microcontroller takes at most. */
  static final double MAX_SPEED = 1;

  static final double MAX_TURN_RATE = 10;
  static final double MAX_SEGMENT_SECONDS = 3_600;

  /** Metres or radians a second squared. */
  static final double MIN_ACCELERATION = 0.01;

  private static final double MAX_ACCELERATION = 50;
  private static final double PACE_UNITS = 1 << 15;
  private static final double STATUS_PACE_UNITS = 255;
  private static final double ARM_PROGRESS_UNITS = 255;

  private FrameCodec() {}

  /**
   * @param sequence 0 to 255
   */
  public static byte[] encode(FirmwareCommand command, int sequence) {
    ByteBuffer frame = ByteBuffer.allocate(LENGTH).order(ByteOrder.LITTLE_ENDIAN);
    frame.putShort(SYNC).put(kind(command)).put((byte) sequence);
    switch (command) {
      case Poll _ -> {}
      case Velocity(var twist) ->
          frame
              .putInt(millionths(twist.vx(), MAX_SPEED))
              .putInt(millionths(twist.vy(), MAX_SPEED))
              .putInt(millionths(twist.w(), MAX_TURN_RATE));
      case Path path -> putPath(frame, path);
      case Segments(int path, int first, boolean onward, var segments) -> {
        frame.putShort((short) path).putShort((short) first);
        putSegments(frame, onward, segments);
      }
      case Clear(var reasons, boolean byPerson) ->
          frame.putShort((short) StopReason.bits(reasons)).put((byte) (byPerson ? 1 : 0));
      case Caption(String text) -> frame.put(caption(text));
      case Settings(FirmwareSettings settings) -> putSettings(frame, settings);
      case ArmMeasures(ArmSettings settings) -> putArmSettings(frame, settings);
      case ArmMove(JointAngles goal, boolean handClosed, boolean onward) ->
          frame
              .putInt((int) Math.round(goal.shoulder() * 1e6))
              .putInt((int) Math.round(goal.elbow() * 1e6))
              .put((byte) (handClosed ? 1 : 0))
              .put((byte) (onward ? 1 : 0));
      case ArmPoll _ -> {}
    }
    return frame.putShort(CRC_OFFSET, (short) Crc16.of(frame.array(), CRC_OFFSET)).array();
  }

  /** Whether the bytes are one frame, with its sync and its check sum. */
  static boolean isIntact(byte[] bytes) {
    if (bytes.length != LENGTH) {
      return false;
    }
    ByteBuffer frame = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    return frame.getShort(0) == SYNC
        && Short.toUnsignedInt(frame.getShort(CRC_OFFSET)) == Crc16.of(bytes, CRC_OFFSET);
  }

  /** Nothing when the bytes are no good status. */
  public static Optional<FirmwareStatus> decode(byte[] bytes) {
    if (!isIntact(bytes)) {
      return Optional.empty();
    }
    ByteBuffer frame = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int answer = frame.get(4);
    int state = frame.get(5);
    if (Byte.toUnsignedInt(frame.get(2)) != STATUS_KIND
        || !isCode(answer, Answer.values())
        || !isCode(state, State.values())) {
      return Optional.empty();
    }
    return Optional.of(
        new FirmwareStatus(
            Byte.toUnsignedInt(frame.get(3)),
            Answer.values()[answer],
            State.values()[state],
            StopReason.ofBits(Short.toUnsignedInt(frame.getShort(6))),
            Short.toUnsignedInt(frame.getShort(8)),
            Integer.toUnsignedLong(frame.getInt(10)),
            List.of(frame.getInt(14), frame.getInt(18), frame.getInt(22)),
            new Pose(frame.getInt(26) / 1e6, frame.getInt(30) / 1e6, frame.getInt(34) / 1e6),
            ranges(frame),
            Short.toUnsignedInt(frame.getShort(44)) / 1e3,
            Byte.toUnsignedInt(frame.get(46)) & FLOOR_BITS,
            Byte.toUnsignedInt(frame.get(46)) >> FirmwareSettings.FLOOR_SENSORS,
            frame.get(57),
            Byte.toUnsignedInt(frame.get(47)),
            Short.toUnsignedInt(frame.getShort(48)),
            Integer.toUnsignedLong(frame.getInt(58)) / 1e6,
            Byte.toUnsignedInt(frame.get(56)) / STATUS_PACE_UNITS,
            Short.toUnsignedInt(frame.getShort(54)),
            Short.toUnsignedInt(frame.getShort(50)),
            Short.toUnsignedInt(frame.getShort(52))));
  }

  /** Nothing when the bytes are no good status of an arm. */
  static Optional<ArmStatus> decodeArm(byte[] bytes) {
    if (!isIntact(bytes)) {
      return Optional.empty();
    }
    ByteBuffer frame = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int state = frame.get(14);
    if (Byte.toUnsignedInt(frame.get(2)) != ARM_STATUS_KIND
        || !isCode(state, ArmStatus.State.values())) {
      return Optional.empty();
    }
    return Optional.of(
        new ArmStatus(
            ArmStatus.State.values()[state],
            frame.get(15) != 0,
            new JointAngles(frame.getInt(16) / 1e6, frame.getInt(20) / 1e6),
            new JointAngles(frame.getInt(24) / 1e6, frame.getInt(28) / 1e6),
            Short.toUnsignedInt(frame.getShort(32)) / 1e3,
            Byte.toUnsignedInt(frame.get(34)) / ARM_PROGRESS_UNITS));
  }

  private static void putPath(ByteBuffer frame, Path path) {
    Pose start = path.start();
    frame
        .putShort((short) path.number())
        .putInt((int) Math.round(start.x() * 1e6))
        .putInt((int) Math.round(start.y() * 1e6))
        .putInt((int) Math.round(start.theta() * 1e6))
        .putShort((short) Math.round(Math.clamp(path.pace(), 0, 1) * PACE_UNITS))
        .putShort(thousandths(path.acceleration()))
        .putShort(thousandths(path.turnAcceleration()));
    putSegments(frame, path.onward(), path.segments());
  }

  private static void putSegments(ByteBuffer frame, boolean onward, List<Segment> segments) {
    frame.put((byte) (onward ? 1 : 0)).put((byte) segments.size());
    for (Segment segment : segments) {
      frame
          .putInt(millionths(segment.v(), MAX_SPEED))
          .putInt(millionths(segment.w(), MAX_TURN_RATE))
          .putInt((int) Math.round(Math.clamp(segment.t(), 0, MAX_SEGMENT_SECONDS) * 1e6));
    }
  }

  private static void putSettings(ByteBuffer frame, FirmwareSettings settings) {
    frame
        .putInt((int) Math.round(settings.wheels().wheelRadius() * 1e6))
        .putInt((int) Math.round(settings.wheels().centreToWheel() * 1e6));
    settings.floorVolts().forEach(volts -> frame.putShort((short) Math.round(volts * 1e3)));
  }

  private static void putArmSettings(ByteBuffer frame, ArmSettings settings) {
    putJoint(frame, settings.arm().shoulder(), settings.shoulder());
    putJoint(frame, settings.arm().elbow(), settings.elbow());
    frame
        .putShort((short) Math.round(settings.openPulse()))
        .putShort((short) Math.round(settings.closedPulse()))
        .putShort((short) Math.round(settings.emptyVolts() * 1e3))
        .putShort((short) Math.round(settings.voltsPerKilogram() * 1e3));
  }

  /** What is faster than the microcontroller takes is slowed down. */
  private static void putJoint(ByteBuffer frame, JointLimits joint, JointWiring wiring) {
    double rate = Math.min(joint.maxRate(), ArmSettings.MOST_RATE);
    double acceleration = Math.min(joint.maxAcceleration(), ArmSettings.MOST_ACCELERATION);
    frame
        .putInt((int) Math.round(joint.least() * 1e6))
        .putInt((int) Math.round(joint.most() * 1e6))
        .putShort((short) Math.round(rate * 1e3))
        .putShort((short) Math.round(acceleration * 1e3))
        .putShort((short) Math.round(wiring.leastPulse()))
        .putShort((short) Math.round(wiring.mostPulse()))
        .putShort((short) Math.round(wiring.leastVolts() * 1e3))
        .putShort((short) Math.round(wiring.mostVolts() * 1e3));
  }

  private static short thousandths(double acceleration) {
    return (short) Math.round(Math.clamp(acceleration, MIN_ACCELERATION, MAX_ACCELERATION) * 1e3);
  }

  private static byte kind(FirmwareCommand command) {
    return switch (command) {
      case Poll _ -> 0;
      case Velocity _ -> 1;
      case Path _ -> 2;
      case Segments _ -> 3;
      case Clear _ -> 4;
      case Caption _ -> 5;
      case Settings _ -> 6;
      case ArmMeasures _ -> 7;
      case ArmMove _ -> 8;
      case ArmPoll _ -> 9;
    };
  }

  private static int millionths(double value, double limit) {
    return (int) Math.round(Math.clamp(value, -limit, limit) * 1e6);
  }

  private static byte[] caption(String text) {
    String printable = text.replaceAll("[^ -~]", "?");
    String filled = printable + " ".repeat(Math.max(0, CAPTION_LENGTH - printable.length()));
    return filled.substring(0, CAPTION_LENGTH).getBytes(StandardCharsets.US_ASCII);
  }

  private static List<Double> ranges(ByteBuffer frame) {
    List<Integer> millimetres =
        Stream.of(38, 40, 42).map(at -> Short.toUnsignedInt(frame.getShort(at))).toList();
    return millimetres.stream().anyMatch(range -> range > FARTHEST_MILLIMETRES)
        ? List.of()
        : millimetres.stream().map(range -> range / 1e3).toList();
  }

  private static <E extends Enum<E>> boolean isCode(int code, E[] values) {
    return code >= 0 && code < values.length;
  }
}
