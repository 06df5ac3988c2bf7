package org.toqa.yaml;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;

/** Finds the word that somebody may have meant. */
public final class Spelling {
  private Spelling() {}

  /**
   * A known word.
   *
   * @param distance letters to change, add or leave out, without regard to case
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

  private static String folded(String word) {
    return word.toLowerCase(Locale.ROOT);
  }

  /** Letters to insert, delete or replace (Levenshtein, 1966), one row of the table at a time. */
  private static int distance(String a, String b) {
    int[] row = new int[b.length() + 1];
    for (int j = 0; j < row.length; j++) {
      row[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j < row.length; j++) {
        int change = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(change, 1 + Math.min(row[j], row[j - 1]));
      }
    }
    return row[b.length()];
  }
}
