package org.toqa.lab.experiment;

import java.util.Arrays;
import java.util.Locale;

/** What a measured figure says of a published one. */
public enum Verdict {
  /** Measured as published, or better where less is better. */
  REPRODUCED,
  /** Measured otherwise. */
  REFUTED,
  /** An input that the figure depends on is not published. */
  NOT_COMPARABLE;

  /** For people and programs: {@code reproduced}, {@code refuted}, {@code not comparable}. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  /**
   * @throws IllegalArgumentException if no verdict has that word
   */
  public static Verdict ofWord(String word) {
    return Arrays.stream(values())
        .filter(verdict -> verdict.word().equals(word))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("No verdict is called " + word + "."));
  }
}
