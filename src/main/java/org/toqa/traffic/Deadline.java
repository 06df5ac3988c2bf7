package org.toqa.traffic;

import java.time.Duration;
import java.util.function.LongSupplier;

/**
 * The moment by which a planner answers with the best it has.
 *
 * @param ticker nanoseconds from any fixed moment, as {@link System#nanoTime}
 * @param end the ticker's value at that moment
 */
public record Deadline(LongSupplier ticker, long end) {

  /**
   * The moment when a limit from now will have passed.
   *
   * @param ticker nanoseconds from any fixed moment
   */
  public static Deadline in(Duration limit, LongSupplier ticker) {
    return new Deadline(ticker, ticker.getAsLong() + limit.toNanos());
  }

  /** Never comes: for planners that end by themselves. */
  public static Deadline none() {
    return new Deadline(() -> 0, Long.MAX_VALUE);
  }

  /**
   * The moment when a part of the time left from now will have passed.
   *
   * @param share from 0 to 1
   */
  public Deadline afterShare(double share) {
    long now = ticker.getAsLong();
    return new Deadline(ticker, now + (long) (share * (end - now)));
  }

  /** Whether it is that late. */
  public boolean isPassed() {
    return ticker.getAsLong() - end >= 0;
  }
}
