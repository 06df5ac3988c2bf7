package org.toqa.app;

import org.toqa.app.bench.Timings;

/** What a bench prints of many times. */
record Milliseconds(long count, double p50Ms, double p99Ms, double maxMs) {
  static Milliseconds of(double[] millis) {
    Timings timings = new Timings(millis);
    return new Milliseconds(
        millis.length, timings.percentile(0.5), timings.percentile(0.99), timings.max());
  }
}
