package org.toqa.link.channel;

import java.time.Duration;

/** How long to wait before the next attempt: twice as long each time, up to a limit. */
public final class Backoff {

  static final Duration SHORTEST = Duration.ofMillis(250);
  public static final Duration LONGEST = Duration.ofSeconds(5);

  private Duration next = SHORTEST;

  public Duration nextDelay() {
    Duration now = next;
    next = now.multipliedBy(2).compareTo(LONGEST) < 0 ? now.multipliedBy(2) : LONGEST;
    return now;
  }

  public void reset() {
    next = SHORTEST;
  }
}
