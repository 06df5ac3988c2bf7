package org.toqa.statistics;

import java.util.Arrays;

/** Many values, all in one unit, such as how long each of many runs took. */
public final class Percentiles {
  private final double[] sorted;

  /**
   * @param values in any order and unit; no NaN
   */
  public Percentiles(double[] values) {
    sorted = values.clone();
    Arrays.sort(sorted);
  }

  /** How many values there are. */
  public int count() {
    return sorted.length;
  }

  /** The arithmetic mean, in the values' unit; 0 where there is no value. */
  public double mean() {
    return Arrays.stream(sorted).average().orElse(0);
  }

  /**
   * The nearest rank (Hyndman and Fan, "Sample quantiles in statistical packages", 1996, definition
   * 1): the smallest value that this share of all does not exceed; 0 where there is no value.
   *
   * @param share above 0, at most 1
   * @return in the values' unit
   * @throws IndexOutOfBoundsException if the share is not that
   */
  public double percentile(double share) {
    return sorted.length == 0 ? 0 : sorted[(int) Math.ceil(share * sorted.length) - 1];
  }

  /** The largest value, in the values' unit; 0 where there is no value. */
  public double max() {
    return percentile(1);
  }
}
