package org.toqa.grid;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** By which moves a robot of a floor drives alone, where it meets nobody. */
public enum Moves {
  /** Straights in eight headings, with round corners. */
  HEADING,

  /** A smooth curve in the plane where one fits, else as {@link #HEADING}. */
  SMOOTH;

  /** The moves of that word. */
  public static Optional<Moves> ofWord(String word) {
    return Arrays.stream(values()).filter(moves -> moves.word().equals(word)).findFirst();
  }

  /** All words, in their order. */
  public static List<String> words() {
    return Arrays.stream(values()).map(Moves::word).toList();
  }

  /** In files and on the wire. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
