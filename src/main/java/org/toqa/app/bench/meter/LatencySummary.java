package org.toqa.app.bench.meter;

import org.toqa.statistics.Percentiles;

/**
 * What a bench prints of many times.
 *
 * @param count how many
 * @param p50Ms median, milliseconds
 * @param p99Ms 99th percentile, milliseconds
 * @param maxMs the longest, milliseconds
 */
public record LatencySummary(long count, double p50Ms, double p99Ms, double maxMs) {

  /**
   * @param millis milliseconds, in any order
   */
  public static LatencySummary of(double[] millis) {
    Percentiles timings = new Percentiles(millis);
    return new LatencySummary(
        millis.length, timings.percentile(0.5), timings.percentile(0.99), timings.max());
  }
}
