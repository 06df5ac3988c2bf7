package org.toqa.avoidance.fouragents;

/**
 * The terms of a fuzzy variable: triangles, each with its feet under the peaks of its neighbours,
 * the outermost ones full beyond their peaks. So the degrees of all terms add up to 1 everywhere.
 */
final class Partition {
  private final double[] peaks;

  /**
   * @param peaks where each term is full, ascending, at least two
   */
  Partition(double... peaks) {
    this.peaks = peaks.clone();
    for (int i = 1; i < peaks.length; i++) {
      if (!(peaks[i] > peaks[i - 1])) {
        throw new IllegalArgumentException("The peaks of terms ascend.");
      }
    }
  }

  int size() {
    return peaks.length;
  }

  /** How far a value belongs to a term, 0 to 1. */
  double degree(int term, double value) {
    if (value <= peaks[term]) {
      return term == 0 ? 1 : rise(peaks[term - 1], peaks[term], value);
    }
    return term == peaks.length - 1 ? 1 : rise(peaks[term + 1], peaks[term], value);
  }

  private static double rise(double foot, double peak, double value) {
    return Math.clamp((value - foot) / (peak - foot), 0, 1);
  }
}
