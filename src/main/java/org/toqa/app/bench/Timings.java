package org.toqa.app.bench;

import java.lang.management.ManagementFactory;
import java.util.Arrays;

/** How long each of many runs took, in one unit of time. */
public final class Timings {
  private final double[] sorted;

  public Timings(double[] times) {
    sorted = times.clone();
    Arrays.sort(sorted);
  }

  /** The time that the calling thread has worked: what others do on the machine is not in it. */
  static double processorMillis() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() / 1e6;
  }

  /** 0 where nothing was timed. */
  public double mean() {
    return Arrays.stream(sorted).average().orElse(0);
  }

  /**
   * The least time that this share of the runs did not exceed; 0 where nothing was timed.
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
