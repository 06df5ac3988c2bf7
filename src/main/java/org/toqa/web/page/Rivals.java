package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import org.jspecify.annotations.Nullable;
import org.toqa.web.Digits;
import org.toqa.web.FieldErrors;
import org.toqa.web.Texts;
import org.toqa.web.Version;

/**
 * Two people at the same form: what the first one has stored, the second one is shown beside his
 * own entries before he replaces it. Entries that are there already replace nothing, as those of a
 * double click.
 */
final class Rivals {
  private final HttpServletRequest request;
  private final Texts texts;
  private final boolean wasChanged;
  private final FieldErrors differences = new FieldErrors();

  /**
   * @param now what there is; a form that does not say what it was filled from is believed
   */
  Rivals(HttpServletRequest request, Version now) {
    this.request = request;
    this.texts = Texts.of(request);
    String before = request.getParameter("version");
    this.wasChanged = before != null && !before.equals(now.text());
  }

  /** Whether the page was filled from another version than there is now. */
  boolean wasChanged() {
    return wasChanged;
  }

  /**
   * Compares an entry of the form, if it has that field.
   *
   * @param now null: nothing
   * @param none how nothing is shown
   */
  Rivals text(String field, @Nullable String now, String none) {
    String there = now == null ? "" : now;
    return entry(field, request.getParameter(field), there, there.isEmpty() ? none : there);
  }

  /**
   * @param shown how {@code now} is shown
   */
  Rivals number(String field, double now, String shown) {
    String entered = request.getParameter(field);
    return compare(
        field,
        entered == null || Digits.number(entered).filter(number -> number == now).isPresent(),
        shown);
  }

  /**
   * @param entered null: the form has no such field
   * @param shown how {@code now} is shown
   */
  Rivals entry(String field, @Nullable String entered, String now, String shown) {
    return compare(field, entered == null || entered.strip().equals(now), shown);
  }

  private Rivals compare(String field, boolean isSame, String shown) {
    if (wasChanged && !isSame) {
      differences.add(field, texts.get("error.changed.now", shown));
    }
    return this;
  }

  /** A sentence for each field whose entry would replace another's, and one for the form. */
  FieldErrors differences() {
    if (!differences.isEmpty()) {
      differences.add("form", texts.get("error.changed"));
    }
    return differences;
  }
}
