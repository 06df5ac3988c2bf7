package org.toqa.mission;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * How far a mission is on its way.
 *
 * @param stop the number, from 0, of the first stop that its robots have not left
 * @param waitingSince when they came there, where they wait there; null: they do not
 * @param fetchedBefore the number of the stop to which the load was carried first from where it was
 *     fetched last: not the first one where it had been set down on its way
 */
public record StopProgress(int stop, @Nullable Instant waitingSince, int fetchedBefore) {

  /** Nothing is fetched yet. */
  public static final StopProgress START = new StopProgress(0, null, 1);

  /**
   * For how long they have waited, of the fleet's time, as far as the clock knows: one that was set
   * back since then knows nothing of it.
   *
   * @param pace seconds of the fleet's time in a second of the clock
   */
  public Duration waited(Instant now, double pace) {
    return waitingSince == null || now.isBefore(waitingSince)
        ? Duration.ZERO
        : Duration.ofMillis(Math.round(pace * Duration.between(waitingSince, now).toMillis()));
  }

  StopProgress withoutWait() {
    return new StopProgress(stop, null, fetchedBefore);
  }

  StopProgress at(int number, @Nullable Instant waiting) {
    return new StopProgress(number, waiting, fetchedBefore);
  }

  /** The load is on board, and goes to that stop first. */
  static StopProgress fetched(int before) {
    return new StopProgress(before, null, before);
  }
}
