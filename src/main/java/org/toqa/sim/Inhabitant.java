package org.toqa.sim;

import java.time.Duration;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A participant of the world, and whether the world waits for it. One that has held the world up to
 * the limit time after time is not waited for any more, until it is ready; it may wait for what
 * never comes. For the clock's thread, but for {@link #isAwaited}.
 */
final class Inhabitant {
  /** So often in a row it may hold the world up to the limit of five seconds. */
  static final int MOST_HOLDS = 6;

  /** Of the world's time: holds that are farther apart are not in a row. */
  static final Duration RECOVERY = Duration.ofMinutes(1);

  private static final Logger log = LoggerFactory.getLogger(Inhabitant.class);

  private final Participant participant;
  private final long period;

  /** In a row; 0: it has not held the world up to the limit yet. */
  private int holds;

  /** When it did so last, nanoseconds of the world. */
  private long heldAt;

  private volatile boolean isGivenUp;

  /**
   * @param period nanoseconds of the world from one tick to the next
   */
  Inhabitant(Participant participant, long period) {
    this.participant = participant;
    this.period = period;
  }

  Participant participant() {
    return participant;
  }

  boolean isDue(long nanos) {
    return nanos % period == 0;
  }

  /** Whether it holds the world up. */
  boolean isAwaited(long nanos) {
    return !isGivenUp && !participant.isReady(nanos);
  }

  /**
   * The world goes on from that time.
   *
   * @param isForced since the limit is reached, though somebody is not ready
   */
  void goOn(long nanos, boolean isForced) {
    if (!isForced && !isGivenUp) {
      return;
    }
    if (participant.isReady(nanos)) {
      if (isGivenUp) {
        log.info("The world waits for {} again, as that is ready.", participant);
      }
      isGivenUp = false;
    } else if (isGivenUp) {
      heldAt = nanos;
    } else {
      recordHold(nanos);
    }
  }

  private void recordHold(long nanos) {
    holds = nanos - heldAt > RECOVERY.toNanos() ? 1 : holds + 1;
    heldAt = nanos;
    if (holds == 1) {
      log.info("The world was held up by {}.", participant);
    } else if (holds >= MOST_HOLDS) {
      log.warn(
          "The world was held up {} times in a row by {}, and waits no more until that is ready.",
          holds,
          participant);
      isGivenUp = true;
    }
  }
}
