package org.toqa.agent.firmware;

import java.util.BitSet;

/**
 * How well the microcontroller and the daemon understand each other: of the last exchanges, how
 * many failed. A link that loses many frames may soon lose the one that says stop.
 */
final class LinkQuality {

  /** Of exchanges; 5 s of driving. */
  private static final int WINDOW = 250;

  private static final int POOR_FAILURES = WINDOW / 5;

  /** So few must be left before the link counts as good again. */
  private static final int GOOD_FAILURES = WINDOW / 50;

  private final BitSet failed = new BitSet(WINDOW);
  private int next;
  private int failures;
  private boolean isPoor;
  private long exchanges;
  private long totalFailures;

  void recordExchange(boolean isAnswered) {
    failures += (isAnswered ? 0 : 1) - (failed.get(next) ? 1 : 0);
    failed.set(next, !isAnswered);
    next = (next + 1) % WINDOW;
    exchanges++;
    totalFailures += isAnswered ? 0 : 1;
    isPoor = failures >= (isPoor ? GOOD_FAILURES : POOR_FAILURES);
  }

  /** Whether so many failed that the robot must not drive. */
  boolean isPoor() {
    return isPoor;
  }

  /** Of all exchanges. */
  long totalFailures() {
    return totalFailures;
  }

  long exchanges() {
    return exchanges;
  }
}
