package org.toqa.fleet.history;

import java.time.Instant;

/**
 * How full a robot's battery was.
 *
 * @param level 0 to 1
 */
public record BatteryLevel(String robot, Instant at, double level) {

  /** A level is written down when it has changed by that much. */
  static final double STEP = 0.01;

  /** Whether it says anything new after the one before. */
  boolean isNewAfter(BatteryLevel before) {
    return Math.round(level / STEP) != Math.round(before.level / STEP);
  }
}
