package org.toqa.link.http;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * How a robot is when it answers an order.
 *
 * @param seq of the last order that it obeyed
 * @param boot another number whenever the counts have begun anew
 * @param stamp milliseconds on the robot's own clock
 * @param left counts of the left wheel's encoder, rising when it rolls forward; only the last 32
 *     bits count
 * @param right the same of the right wheel
 * @param battery 0 to 1; null: it does not say
 * @param ranges metres, from right to left; null: it has no sensors, or does not say
 * @param errors why it cannot drive; empty where it can
 */
public record WheelReport(
    long seq,
    long boot,
    long stamp,
    long left,
    long right,
    @Nullable Double battery,
    @Nullable List<Double> ranges,
    List<RobotError> errors) {

  public WheelReport {
    ranges = ranges == null ? null : List.copyOf(ranges);
    errors = List.copyOf(errors);
  }

  /**
   * What keeps a robot from driving.
   *
   * @param code capital letters, digits and _, 32 at most
   * @param text a sentence for people
   */
  public record RobotError(String code, String text) {}
}
