package org.toqa.web.input;

import java.util.Locale;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * What somebody looks for in a list: anything that has it in it, in capitals or not.
 *
 * @param wanted null: all is wanted
 */
record SearchText(@Nullable String wanted) {
  static SearchText of(QueryFields fields) {
    String given = fields.text("text");
    return new SearchText(given == null ? null : comparable(Digits.latin(given)));
  }

  boolean isGiven() {
    return wanted != null;
  }

  /** Whether one of these has it. */
  boolean isIn(@Nullable String... texts) {
    return wanted == null
        || Stream.of(texts).anyMatch(text -> text != null && comparable(text).contains(wanted));
  }

  private static String comparable(String text) {
    return text.toLowerCase(Locale.ROOT);
  }
}
