package org.toqa.lab.cmct;

import java.util.Arrays;
import java.util.Locale;

/** Mean and standard deviation of what chance made. */
record Spread(double mean, double deviation) {

  static Spread of(double... values) {
    double mean = Arrays.stream(values).average().orElse(Double.NaN);
    double squares = Arrays.stream(values).map(v -> (v - mean) * (v - mean)).sum();
    return new Spread(mean, values.length < 2 ? 0 : Math.sqrt(squares / (values.length - 1)));
  }

  /** The one divided by the other, pair by pair. */
  static Spread ofRatios(double[] values, double[] by) {
    double[] ratios = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      ratios[i] = values[i] / by[i];
    }
    return of(ratios);
  }

  /**
   * For a person.
   *
   * @param decimals of both
   */
  String text(int decimals) {
    return String.format(Locale.ROOT, "%." + decimals + "f ± %." + decimals + "f", mean, deviation);
  }
}
