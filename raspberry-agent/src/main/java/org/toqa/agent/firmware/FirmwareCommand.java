package org.toqa.agent.firmware;

import java.util.Set;
import org.toqa.geometry.Twist;

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
   * Drive this at the end of the queue.
   *
   * @param v metres a second, forward
   * @param w radians a second, counter-clockwise
   * @param t seconds, positive
   */
  record CurveSegment(double v, double w, double t) implements FirmwareCommand {}

  /** Slow down, stop, and drop the queue. */
  record Halt() implements FirmwareCommand {}

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
}
