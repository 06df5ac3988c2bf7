package org.toqa.fleet.history;

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
public record DurationStatistics(int count, double mean, double median, double p90) {
  private static final double MICROSECONDS = 1e6;

  /** Null where there is nothing to say. */
  static @Nullable public DurationStatistics of(long[] microseconds) {
    if (microseconds.length == 0) {
      return null;
    }
    long[] sorted = microseconds.clone();
    Arrays.sort(sorted);
    return new DurationStatistics(
        sorted.length,
        Arrays.stream(sorted).average().orElseThrow() / MICROSECONDS,
        percentile(sorted, 0.5),
        percentile(sorted, 0.9));
  }

  /** The nearest rank: the smallest value that this share of all does not exceed. */
  private static double percentile(long[] sorted, double share) {
    return sorted[(int) Math.ceil(share * sorted.length) - 1] / MICROSECONDS;
  }
}
