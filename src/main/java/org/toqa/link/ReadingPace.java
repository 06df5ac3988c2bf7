package org.toqa.link;

import java.time.Duration;

/**
 * How many lines of one robot are read in a while, so that one that says very much takes no
 * processor from others: its lines wait in the network then. By real time, since it is real work.
 */
final class ReadingPace {
  /** In a second, and after a pause at once; a robot says ten to twenty. */
  static final int LINES = 2_000;

  private static final long NANOS_A_LINE = Duration.ofSeconds(1).toNanos() / LINES;

  /** Until then all that may be read has been read; a second ahead of now at most. */
  private long usedUntil;

  ReadingPace(long nanos) {
    usedUntil = nanos - Duration.ofSeconds(1).toNanos();
  }

  /**
   * A line is to be read.
   *
   * @param nanos now, on a monotonic clock
   * @return nanoseconds to wait before that
   */
  long acquire(long nanos) {
    usedUntil = Math.max(usedUntil, nanos - Duration.ofSeconds(1).toNanos()) + NANOS_A_LINE;
    return Math.max(0, usedUntil - nanos);
  }
}
