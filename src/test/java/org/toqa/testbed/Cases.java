package org.toqa.testbed;

import static org.junit.jupiter.api.Assertions.assertTrue;

/**
 * Counts which of the cases that chance has made are any good: a test that found nothing to try has
 * shown nothing.
 */
public final class Cases {
  private final String kind;
  private long made;
  private long possible;

  /**
   * @param kind what {@link Tally} calls them, in the plural
   */
  public Cases(String kind) {
    this.kind = kind;
  }

  /** Returns what it is given. */
  public synchronized boolean count(boolean isPossible) {
    made++;
    possible += isPossible ? 1 : 0;
    return isPossible;
  }

  /** Tells how many there were. */
  public synchronized void assertPossible(double leastShare) {
    Tally.add(kind, possible);
    assertTrue(
        made > 0 && possible >= leastShare * made,
        () ->
            "only %d of %d %s were possible, not the %.0f %% that must be"
                .formatted(possible, made, kind, 100 * leastShare));
  }
}
