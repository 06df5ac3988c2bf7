package org.toqa.mission;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * A place on a mission's way, with what its robots wait for there before they drive on.
 *
 * @param awaitsPerson whether they wait until a person says that they may go on
 * @param waitTime how long they wait after they have come; null: not at all. With a person, who
 *     comes first decides
 */
public record Stop(TaskPlace place, boolean awaitsPerson, @Nullable Duration waitTime) {

  /** One at which nobody waits. */
  public static Stop at(TaskPlace place) {
    return new Stop(place, false, null);
  }

  /**
   * How long they still wait here, of the fleet's time, 0 or less where that is over; empty: a
   * person alone is waited for, or nobody.
   *
   * @param since when they came
   * @param pace seconds of the fleet's time in a second of the clock
   */
  public Optional<Duration> waitLeft(Instant since, Instant now, double pace) {
    return Optional.ofNullable(waitTime)
        .map(wait -> wait.minusMillis(Math.round(pace * Duration.between(since, now).toMillis())));
  }

  public boolean hasWait() {
    return awaitsPerson || waitTime != null;
  }
}
