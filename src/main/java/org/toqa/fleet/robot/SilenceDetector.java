package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;

/** Tells when a robot falls silent. Confined to its agent. */
final class SilenceDetector {
  private static final Duration SILENT_AFTER = Duration.ofSeconds(2);

  private Instant lastHeard;
  private boolean silent;

  SilenceDetector(Instant now) {
    this.lastHeard = now;
  }

  void recordHeard(Instant now) {
    lastHeard = now;
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
   * Counts the robot as silent if it was not heard for long enough.
   *
   * @return whether it has just become so
   */
  boolean detectSilence(Instant now) {
    if (silent || !lastHeard.plus(SILENT_AFTER).isBefore(now)) {
      return false;
    }
    silent = true;
    return true;
  }
}
