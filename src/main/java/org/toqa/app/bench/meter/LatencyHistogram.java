package org.toqa.app.bench.meter;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.atomic.LongAccumulator;

/**
 * Counts latencies by tenths of a millisecond: millions of them take no more room than one.
 * Thread-safe.
 */
public final class LatencyHistogram {
  private static final int BINS_A_MILLISECOND = 10;

  /** The last one counts all that took longer, too. */
  private static final int BINS = 60_000 * BINS_A_MILLISECOND;

  private final AtomicLongArray counts = new AtomicLongArray(BINS);
  private final LongAccumulator maxNanos = new LongAccumulator(Math::max, 0);

  /** One that cannot be below nothing, but that clocks are read one after the other. */
  public void add(Instant from, Instant to) {
    long nanos = Math.max(0, Duration.between(from, to).toNanos());
    maxNanos.accumulate(nanos);
    counts.incrementAndGet((int) Math.min(BINS - 1, nanos * BINS_A_MILLISECOND / 1_000_000));
  }

  /** Discards what was counted. */
  public void reset() {
    for (int bin = 0; bin < BINS; bin++) {
      counts.set(bin, 0);
    }
    maxNanos.reset();
  }

  /** Percentiles are the upper ends of their tenths; never more than the longest. */
  public LatencySummary summary() {
    long total = 0;
    for (int bin = 0; bin < BINS; bin++) {
      total += counts.get(bin);
    }
    double max = maxNanos.get() / 1e6;
    return new LatencySummary(
        total, percentile(0.5, total, max), percentile(0.99, total, max), max);
  }

  private double percentile(double share, long total, double max) {
    long rank = (long) Math.ceil(share * total);
    long below = 0;
    for (int bin = 0; bin < BINS - 1; bin++) {
      below += counts.get(bin);
      if (below >= rank) {
        return Math.min(max, (bin + 1.0) / BINS_A_MILLISECOND);
      }
    }
    return max;
  }
}
