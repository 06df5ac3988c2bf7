package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;

/**
 * Tells when a robot falls silent: by the time that its agent was there to hear it, so that a
 * server that was held up hears first what came meanwhile. Confined to its agent.
 */
final class SilenceDetector {
  private static final Duration SILENT_AFTER = Duration.ofSeconds(2);

  /** Of the time between two ticks no more than this counts. */
  private static final Duration LONGEST_STEP = Duration.ofMillis(500);

  private Instant lastHeard;
  private Instant lastTick;
  private Duration unheard = Duration.ZERO;
  private boolean silent;

  SilenceDetector(Instant now) {
    this.lastHeard = now;
    this.lastTick = now;
  }

  void recordHeard(Instant now) {
    lastHeard = now;
    unheard = Duration.ZERO;
  }

  boolean isSilent() {
    return silent;
  }

  Instant lastHeard() {
    return lastHeard;
  }

  /** Counts the robot as heard from now on, until it falls silent. */
  void endSilence() {
    silent = false;
  }

  /**
   * Counts the robot as silent if it was not heard for long enough. To be called at each tick.
   *
   * @return whether it has just become so
   */
  boolean detectSilence(Instant now) {
    Duration step = Duration.between(lastTick, now);
    unheard = unheard.plus(step.compareTo(LONGEST_STEP) < 0 ? step : LONGEST_STEP);
    lastTick = now;
    if (silent || unheard.compareTo(SILENT_AFTER) <= 0) {
      return false;
    }
    silent = true;
    return true;
  }
}
