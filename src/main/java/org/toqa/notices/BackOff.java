package org.toqa.notices;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;

/** When something that failed is tried again: later each time, and for a day. */
final class BackOff {
  static final Duration GIVE_UP_AFTER = Duration.ofHours(24);
  private static final Duration FIRST = Duration.ofSeconds(5);
  private static final int FACTOR = 4;
  static final Duration LONGEST = Duration.ofHours(2);

  private BackOff() {}

  /** 5 s, 20 s, 80 s, 320 s, 21 min, 85 min, and then every two hours. */
  static Duration pause(int attempts) {
    Duration pause = FIRST;
    for (int i = 1; i < attempts && pause.compareTo(LONGEST) < 0; i++) {
      pause = pause.multipliedBy(FACTOR);
    }
    return pause.compareTo(LONGEST) > 0 ? LONGEST : pause;
  }

  /**
   * When to try it again; empty: not any more.
   *
   * @param attempts that failed, with this one
   * @param acceptedAt since when it was to be told
   */
  static Optional<Instant> next(int attempts, Instant acceptedAt, Instant now) {
    Instant next = now.plus(pause(attempts));
    return next.isAfter(acceptedAt.plus(GIVE_UP_AFTER)) ? Optional.empty() : Optional.of(next);
  }
}
