package org.toqa.app.config;

import java.util.List;

/** What the value of a setting may be. */
sealed interface ValueRange {

  /** For a sentence, behind "it must be". */
  String description();

  /**
   * One whole number.
   *
   * @param min the smallest that is allowed
   * @param max the largest that is allowed
   * @param unit in the plural; empty: it has none
   * @param note what a value means, with what parts it from the range; empty: nothing
   */
  record WholeNumber(int min, int max, String unit, String note) implements ValueRange {
    WholeNumber(int min, int max, String unit) {
      this(min, max, unit, "");
    }

    WholeNumber(int min, int max) {
      this(min, max, "");
    }

    @Override
    public String description() {
      return "a whole number" + of(unit) + " from " + min + " to " + max + note;
    }

    boolean contains(int value) {
      return value >= min && value <= max;
    }
  }

  /**
   * Whole numbers with commas between them.
   *
   * @param min the smallest that is allowed
   * @param max the largest that is allowed
   * @param unit in the plural
   */
  record WholeNumbers(int min, int max, String unit) implements ValueRange {
    @Override
    public String description() {
      return "whole numbers"
          + of(unit)
          + " from "
          + min
          + " to "
          + max
          + " with commas between them";
    }

    boolean contains(int value) {
      return value >= min && value <= max;
    }
  }

  /**
   * One number, with or without decimals.
   *
   * @param min the smallest that is allowed
   * @param max the largest that is allowed
   * @param unit in the plural; empty: it has none
   */
  record Decimal(double min, double max, String unit) implements ValueRange {
    @Override
    public String description() {
      return "a number" + of(unit) + " from " + plain(min) + " to " + plain(max);
    }

    boolean contains(double value) {
      return value >= min && value <= max; // not so for NaN
    }

    private static String plain(double number) {
      return number == Math.rint(number) ? String.valueOf((long) number) : String.valueOf(number);
    }
  }

  /** One of these words. */
  record Choice(List<String> words) implements ValueRange {
    private static final int MAX_IN_PROSE = 3;

    public Choice {
      words = List.copyOf(words);
    }

    Choice(String... words) {
      this(List.of(words));
    }

    @Override
    public String description() {
      return words.size() > MAX_IN_PROSE
          ? "one of " + String.join(", ", words)
          : String.join(", ", words.subList(0, words.size() - 1)) + " or " + words.getLast();
    }
  }

  /** Anything that the description fits; the reader checks it by itself. */
  record Text(String description) implements ValueRange {}

  private static String of(String unit) {
    return unit.isEmpty() ? "" : " of " + unit;
  }
}
