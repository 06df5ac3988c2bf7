package org.toqa.fleet;

import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Twist;

/**
 * What a person who drives a robot by hand wants of it for the next moment. It must be said again
 * and again: without it the robot stands within half a second.
 *
 * @param lease from the first answer; null: to begin
 * @param number rises from order to order; one that is not higher than another before is too late,
 *     and changes nothing
 * @param speed metres a second, forward; below 0 backward
 * @param turnRate radians a second, counter-clockwise
 */
public record ManualOrder(@Nullable UUID lease, long number, double speed, double turnRate) {
  /**
   * Metres a second: with 0.3 s to drive a robot that brakes by 0.5 m/s^2 stands after 0.3 s +
   * 0.12/0.5/2 s = 0.42 s.
   */
  public static final double MAX_SPEED = 0.12;

  /** Radians a second: likewise, with 3 rad/s^2, 0.4 s. */
  public static final double MAX_TURN_RATE = 0.6;

  /** Whether it shall stand at once. */
  public boolean isStop() {
    return speed == 0 && turnRate == 0;
  }

  public Twist twist() {
    return new Twist(speed, 0, turnRate);
  }
}
