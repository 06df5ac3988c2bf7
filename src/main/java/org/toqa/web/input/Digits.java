package org.toqa.web.input;

import java.util.Optional;
import java.util.regex.Pattern;

/** How people type numbers. */
public final class Digits {
  /** Without exponents: nobody weighs 1e3 kg, and who types it has slipped. */
  private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d+(\\.\\d*)?|\\.\\d+)");

  /** What can be nothing but a decimal comma: three digits behind one may be thousands. */
  private static final Pattern DECIMAL_COMMA = Pattern.compile("[+-]?\\d+,\\d{1,2}");

  private static final int MAX_LENGTH = 40;

  private Digits() {}

  /** The number, if it is one. */
  public static Optional<Double> number(String typed) {
    String number = latin(typed);
    return number.length() <= MAX_LENGTH && NUMBER.matcher(number).matches()
        ? Optional.of(Double.valueOf(number))
        : Optional.empty();
  }

  /** The same, where nothing but a decimal comma can be meant by a comma. */
  public static Optional<Double> enteredNumber(String typed) {
    String entered = latin(typed);
    return number(DECIMAL_COMMA.matcher(entered).matches() ? entered.replace(',', '.') : entered);
  }

  /**
   * The number as a program reads it: digits and decimal separator of the Arabic script become
   * those of the Latin one; the marks of direction that copied text brings along go.
   */
  public static String latin(String typed) {
    StringBuilder latin = new StringBuilder();
    for (int i = 0; i < typed.length(); i++) {
      char c = typed.charAt(i);
      switch (c) {
        case '\u200E', '\u200F', '\u061C' -> {}
        case '\u066B' -> latin.append('.');
        default -> latin.append(isArabic(c) ? (char) ('0' + Character.digit(c, 10)) : c);
      }
    }
    return latin.toString().strip();
  }

  private static boolean isArabic(char c) {
    return (c >= '\u0660' && c <= '\u0669') || (c >= '\u06F0' && c <= '\u06F9');
  }
}
