package org.toqa.statistics;

import java.util.Arrays;

/** Many values, all in one unit, such as how long each of many runs took. */
public final class Percentiles {
  private final double[] sorted;

  public Percentiles(double[] values) {
    sorted = values.clone();
    Arrays.sort(sorted);
  }

  public int count() {
    return sorted.length;
  }

  /** 0 where there is no value. */
  public double mean() {
    return Arrays.stream(sorted).average().orElse(0);
  }

  /**
   * The nearest rank: the smallest value that this share of all does not exceed; 0 where there is
   * no value.
   *
   * @param share above 0, at most 1
   */
  public double percentile(double share) {
    return sorted.length == 0 ? 0 : sorted[(int) Math.ceil(share * sorted.length) - 1];
  }

  public double max() {
    return percentile(1);
  }
}
