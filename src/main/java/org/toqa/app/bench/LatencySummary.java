package org.toqa.app.bench;

import org.toqa.statistics.Percentiles;

/** What a bench prints of many times. */
record LatencySummary(long count, double p50Ms, double p99Ms, double maxMs) {
  static LatencySummary of(double[] millis) {
    Percentiles timings = new Percentiles(millis);
    return new LatencySummary(
        millis.length, timings.percentile(0.5), timings.percentile(0.99), timings.max());
  }
}
