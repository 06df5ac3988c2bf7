package org.toqa.fleet;

import java.time.Duration;

/**
 * When robots charge, and how long that takes.
 *
 * @param below a battery that has less, of 0 to 1, is charged
 * @param until as far as this, of 0 to 1
 * @param work a robot that has worked for so long since it last charged, charges
 * @param toFull how long an empty battery takes to be full; for estimates of who is done when
 * @param patience a charging point at which a battery has not risen for so long does not charge
 */
public record ChargingRules(
    double below, double until, Duration work, Duration toFull, Duration patience) {
  /** The six hours are CMCT's ("Self-recharging"). */
  public static final ChargingRules USUAL =
      new ChargingRules(
          0.20, 0.95, Duration.ofHours(6), Duration.ofMinutes(30), Duration.ofMinutes(10));

  /** As far as a robot is charged where others wait: half of the way. */
  public double untilWhileOthersWait() {
    return (below + until) / 2;
  }
}
