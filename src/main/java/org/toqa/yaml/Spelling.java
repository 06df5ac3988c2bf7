package org.toqa.yaml;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;

/** Finds the word that somebody may have meant. */
public final class Spelling {
  private Spelling() {}

  /**
   * A known word.
   *
   * @param distance letters to change, add, leave out or swap, without regard to case
   */
  public record Suggestion(String word, int distance) {}

  /**
   * The nearest of the known words; of several the first.
   *
   * @param known at least one
   */
  public static Suggestion nearest(String written, Collection<String> known) {
    return known.stream()
        .map(word -> new Suggestion(word, distance(folded(written), folded(word))))
        .min(Comparator.comparingInt(Suggestion::distance))
        .orElseThrow();
  }

  /** The nearest, unless more than a third of what was written is other than it. */
  public static Optional<String> near(String written, Collection<String> known) {
    return Optional.of(nearest(written, known))
        .filter(nearest -> 3 * nearest.distance() <= written.length())
        .map(Suggestion::word);
  }

  private static String folded(String word) {
    return word.toLowerCase(Locale.ROOT);
  }

  /** Letters to insert, delete, replace or swap with the next one (Damerau, 1964). */
  private static int distance(String a, String b) {
    int[][] table = new int[a.length() + 1][b.length() + 1];
    for (int i = 0; i <= a.length(); i++) {
      for (int j = 0; j <= b.length(); j++) {
        table[i][j] = i == 0 || j == 0 ? i + j : distance(a, b, i, j, table);
      }
    }
    return table[a.length()][b.length()];
  }

  private static int distance(String a, String b, int i, int j, int[][] table) {
    int change = table[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
    int least = Math.min(change, 1 + Math.min(table[i - 1][j], table[i][j - 1]));
    boolean isSwapped =
        i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1);
    return isSwapped ? Math.min(least, table[i - 2][j - 2] + 1) : least;
  }
}
