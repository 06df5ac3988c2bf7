package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/** For how long a condition has held without a break. */
final class ConditionTimer {
  private @Nullable Instant since;

  /** Whether the condition holds now, and has held for so long. To be called once a tick. */
  boolean update(boolean holds, Duration duration, Instant now) {
    if (!holds) {
      since = null;
      return false;
    }
    if (since == null) {
      since = now;
    }
    return !since.plus(duration).isAfter(now);
  }
}
