package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/** What a robot's arm was told for its mission, as far as its floor must know it. */
final class ArmWork {
  /** A robot whose arm was told something says so by then. */
  private static final Duration BEGINS_WITHIN = Duration.ofSeconds(2);

  private @Nullable Long running;
  private Instant toldAt = Instant.MIN;
  private long lastEnded;

  /**
   * The robot says what its arm does.
   *
   * @param act its number; null: nothing
   */
  void setRunning(@Nullable Long act) {
    running = act;
  }

  /** A robot that has connected anew knows nothing of what was told and not taken. */
  void reconnect(@Nullable Long act) {
    running = act;
    toldAt = Instant.MIN;
  }

  void setTold(Instant now) {
    toldAt = now;
  }

  /** Whether it does something, or was just told to. */
  boolean isActing(Instant now) {
    return running != null || toldAt.plus(BEGINS_WITHIN).isAfter(now);
  }

  /**
   * An act has ended; the robot says so until it is acknowledged.
   *
   * @return whether that is new
   */
  boolean end(long act) {
    boolean isNew = act != lastEnded;
    lastEnded = act;
    running = null;
    toldAt = Instant.MIN;
    return isNew;
  }
}
