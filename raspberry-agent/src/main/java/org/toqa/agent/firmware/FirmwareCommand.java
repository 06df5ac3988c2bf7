package org.toqa.agent.firmware;

import java.util.List;
import java.util.Set;
import org.toqa.arm.JointAngles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.Segment;

/** What the microcontroller can be commanded; {@code docs/spi-frame.md} says what each does. */
public sealed interface FirmwareCommand {

  /** Asks how the robot is. */
  record Poll() implements FirmwareCommand {}

  /**
   * Drive like this for the next 200 ms.
   *
   * @param twist robot frame
   */
  record Velocity(Twist twist) implements FirmwareCommand {}

  /**
   * Drive another path.
   *
   * @param number of the path, 1 to 65535, another one than that of the path before
   * @param start of its first segment, in the frame of the odometry
   * @param pace with which it begins, 0 to 1
   * @param acceleration metres a second squared
   * @param turnAcceleration radians a second squared
   * @param onward false: slow down on the path, and stand there
   * @param segments its first ones, at most {@value #MOST_SEGMENTS}
   */
  record Path(
      int number,
      Pose start,
      double pace,
      double acceleration,
      double turnAcceleration,
      boolean onward,
      List<Segment> segments)
      implements FirmwareCommand {
    static final int MOST_SEGMENTS = 3;

    public Path {
      segments = List.copyOf(segments);
    }
  }

  /**
   * Drive these too, on the path that you drive.
   *
   * @param path its number
   * @param first which of the path's segments the first of these is, modulo 65536
   * @param onward as above
   * @param segments at most {@value #MOST_SEGMENTS}
   */
  record Segments(int path, int first, boolean onward, List<Segment> segments)
      implements FirmwareCommand {
    static final int MOST_SEGMENTS = 4;

    public Segments {
      segments = List.copyOf(segments);
    }
  }

  /**
   * What stopped the robot is over.
   *
   * @param byPerson whether a person has said so
   */
  record Clear(Set<StopReason> reasons, boolean byPerson) implements FirmwareCommand {
    public Clear {
      reasons = Set.copyOf(reasons);
    }
  }

  /**
   * The first line of the display.
   *
   * @param text cut or filled to 20 characters; what is not ASCII becomes a question mark
   */
  record Caption(String text) implements FirmwareCommand {}

  /** What differs from robot to robot. */
  record Settings(FirmwareSettings settings) implements FirmwareCommand {}

  /** What differs from arm to arm. */
  record ArmMeasures(ArmSettings settings) implements FirmwareCommand {}

  /**
   * Bring the arm's joints there, for the next 200 ms.
   *
   * @param goal within the limits of the joints
   * @param handClosed whether the hand is to be closed
   * @param onward false: slow down on the way, and stand there
   */
  record ArmMove(JointAngles goal, boolean handClosed, boolean onward) implements FirmwareCommand {}

  /** Asks how the arm is. */
  record ArmPoll() implements FirmwareCommand {}

  /** Whether the status of the arm answers it. */
  default boolean isOfArm() {
    return this instanceof ArmMove || this instanceof ArmPoll;
  }
}
