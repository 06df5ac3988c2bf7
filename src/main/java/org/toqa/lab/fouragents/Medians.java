package org.toqa.lab.fouragents;

import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.toqa.statistics.Percentiles;

/** Percentiles of drives, as cells of tables; NaN where there is no drive. */
final class Medians {
  private Medians() {}

  static <T> double of(List<T> drives, ToDoubleFunction<T> value) {
    return percentile(drives, value, 0.5);
  }

  /**
   * @param share above 0, at most 1
   */
  static <T> double percentile(List<T> drives, ToDoubleFunction<T> value, double share) {
    return drives.isEmpty()
        ? Double.NaN
        : new Percentiles(drives.stream().mapToDouble(value).toArray()).percentile(share);
  }

  static String text(double number, int decimals) {
    return Double.isNaN(number) ? "-" : String.format(Locale.ROOT, "%." + decimals + "f", number);
  }
}
