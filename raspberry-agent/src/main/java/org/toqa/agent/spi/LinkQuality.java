package org.toqa.agent.spi;

import java.util.BitSet;

/**
 * How well the microcontroller and the daemon understand each other: of the last exchanges, how
 * many failed. A link that loses many frames may soon lose the one that says stop.
 */
final class LinkQuality {

  /** Of exchanges; 5 s of driving. */
  private static final int WINDOW = 250;

  private static final int TOO_MANY = WINDOW / 5;

  /** So few must be left before the link counts as good again. */
  private static final int FEW = WINDOW / 50;

  private final BitSet failed = new BitSet(WINDOW);
  private int next;
  private int failures;
  private boolean poor;
  private long exchanges;
  private long allFailures;

  void count(boolean isAnswered) {
    failures += (isAnswered ? 0 : 1) - (failed.get(next) ? 1 : 0);
    failed.set(next, !isAnswered);
    next = (next + 1) % WINDOW;
    exchanges++;
    allFailures += isAnswered ? 0 : 1;
    poor = failures >= (poor ? FEW : TOO_MANY);
  }

  /** Whether so many failed that the robot must not drive. */
  boolean isPoor() {
    return poor;
  }

  /** Of all exchanges. */
  long failures() {
    return allFailures;
  }

  long exchanges() {
    return exchanges;
  }
}
