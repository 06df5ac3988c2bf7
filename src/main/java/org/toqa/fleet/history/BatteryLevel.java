package org.toqa.fleet.history;

import java.time.Duration;
import java.time.Instant;

/**
 * How full a robot's battery was.
 *
 * @param level 0 to 1
 */
public record BatteryLevel(String robot, Instant at, double level) {

  private static final double STEP = 0.01;

  /** A battery changes more slowly; a robot that says otherwise fills no database. */
  private static final Duration SHORTEST = Duration.ofSeconds(2);

  /** Whether it says anything new after the one before. */
  boolean isNewAfter(BatteryLevel before) {
    return Math.round(level / STEP) != Math.round(before.level / STEP)
        && !at.isBefore(before.at.plus(SHORTEST));
  }
}
