package org.toqa.lab.experiment;

import java.math.BigDecimal;
import java.math.MathContext;

/** What a figure is: a number, words, or nothing where there is none. */
public sealed interface Value {
  /** Where there is none. */
  Value NONE = new None();

  /** For a person, with its unit. */
  String text();

  /**
   * @param unit such as {@code cm}; empty for a plain number
   */
  record Quantity(double number, String unit) implements Value {
    private static final MathContext DIGITS = new MathContext(6);

    @Override
    public String text() {
      String digits =
          Double.isFinite(number)
              ? new BigDecimal(number).round(DIGITS).stripTrailingZeros().toPlainString()
              : Double.toString(number);
      return unit.isEmpty() ? digits : digits + " " + unit;
    }
  }

  record Words(String text) implements Value {}

  record None() implements Value {
    @Override
    public String text() {
      return "-";
    }
  }

  static Value of(double number, String unit) {
    return new Quantity(number, unit);
  }

  static Value of(String words) {
    return new Words(words);
  }
}
