package org.toqa.store;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * How long something took, over some tasks.
 *
 * @param count of tasks, at least one
 * @param mean seconds
 * @param median seconds that half of the tasks did not exceed
 * @param p90 seconds that nine of ten tasks did not exceed
 */
public record Spread(int count, double mean, double median, double p90) {
  private static final double MICROSECONDS = 1e6;

  /** Null where there is nothing to say. */
  static @Nullable Spread of(long[] microseconds) {
    if (microseconds.length == 0) {
      return null;
    }
    long[] sorted = microseconds.clone();
    Arrays.sort(sorted);
    return new Spread(
        sorted.length,
        Arrays.stream(sorted).average().orElseThrow() / MICROSECONDS,
        atMost(sorted, 0.5),
        atMost(sorted, 0.9));
  }

  /** The nearest rank: the smallest value that this share of all does not exceed. */
  private static double atMost(long[] sorted, double share) {
    return sorted[(int) Math.ceil(share * sorted.length) - 1] / MICROSECONDS;
  }
}
