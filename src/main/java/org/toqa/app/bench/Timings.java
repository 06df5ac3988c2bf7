package org.toqa.app.bench;

import java.util.Arrays;

/** How long each of many runs took, in one unit of time. */
final class Timings {
  private final double[] sorted;

  Timings(double[] times) {
    sorted = times.clone();
    Arrays.sort(sorted);
  }

  /** 0 where nothing was timed. */
  double mean() {
    return Arrays.stream(sorted).average().orElse(0);
  }

  /**
   * The least time that this share of the runs did not exceed; 0 where nothing was timed.
   *
   * @param share above 0, at most 1
   */
  double percentile(double share) {
    return sorted.length == 0 ? 0 : sorted[(int) Math.ceil(share * sorted.length) - 1];
  }

  double max() {
    return percentile(1);
  }
}
