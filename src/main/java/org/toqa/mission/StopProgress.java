package org.toqa.mission;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * How far a mission is on its way.
 *
 * @param stop the number, from 0, of the first stop that its robots have not left
 * @param waitingSince when they came there, where they wait there; null: they do not
 */
public record StopProgress(int stop, @Nullable Instant waitingSince) {

  /** Nothing is fetched yet. */
  public static final StopProgress START = new StopProgress(0, null);

  StopProgress withoutWait() {
    return new StopProgress(stop, null);
  }
}
