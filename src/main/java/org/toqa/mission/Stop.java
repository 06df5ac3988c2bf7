package org.toqa.mission;

import java.time.Duration;
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

  public boolean hasWait() {
    return awaitsPerson || waitTime != null;
  }
}
