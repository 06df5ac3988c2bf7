package org.toqa.fleet.history;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.toqa.statistics.Percentiles;

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

  /**
   * Of durations of tasks, in any order; null where there are none.
   *
   * @param microseconds one duration a task, at least 0
   */
  public static @Nullable DurationStatistics of(long[] microseconds) {
    if (microseconds.length == 0) {
      return null;
    }
    Percentiles durations = new Percentiles(Arrays.stream(microseconds).asDoubleStream().toArray());
    return new DurationStatistics(
        durations.count(),
        durations.mean() / MICROSECONDS,
        durations.percentile(0.5) / MICROSECONDS,
        durations.percentile(0.9) / MICROSECONDS);
  }
}
