package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import org.jspecify.annotations.Nullable;
import org.toqa.web.Texts;
import org.toqa.web.input.Digits;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.Version;

/**
 * Two people at the same form: what the first one has stored, the second one is shown beside his
 * own entries before he replaces it. Entries that are there already replace nothing, as those of a
 * double click.
 */
final class EditConflict {
  private final HttpServletRequest request;
  private final Texts texts;
  private final boolean isStale;
  private final FieldErrors differences = new FieldErrors();

  /**
   * @param stored what there is; a form that does not say what it was filled from is believed
   */
  EditConflict(HttpServletRequest request, Version stored) {
    this.request = request;
    this.texts = Texts.of(request);
    String before = request.getParameter("version");
    this.isStale = before != null && !before.equals(stored.text());
  }

  /** Whether the page was filled from another version than there is now. */
  boolean isStale() {
    return isStale;
  }

  /**
   * Compares an entry of the form, if it has that field.
   *
   * @param stored null: nothing
   * @param none how nothing is shown
   */
  EditConflict compareText(String field, @Nullable String stored, String none) {
    String storedText = stored == null ? "" : stored;
    return compareEntry(field, storedText, storedText.isEmpty() ? none : storedText);
  }

  /**
   * @param shown how {@code stored} is shown
   */
  EditConflict compareNumber(String field, double stored, String shown) {
    String entered = request.getParameter(field);
    return compare(
        field,
        entered == null || Digits.number(entered).filter(number -> number == stored).isPresent(),
        shown);
  }

  /**
   * Compares an entry of the form, if it has that field.
   *
   * @param shown how {@code stored} is shown
   */
  EditConflict compareEntry(String field, String stored, String shown) {
    String entered = request.getParameter(field);
    return compare(field, entered == null || entered.strip().equals(stored), shown);
  }

  /**
   * Compares a box of the form, which is sent only where it is ticked.
   *
   * @param shown how {@code stored} is shown
   */
  EditConflict compareFlag(String field, boolean stored, String shown) {
    return compare(field, request.getParameter(field) != null == stored, shown);
  }

  /** A text in the reader's language, to show what is stored. */
  String text(String key) {
    return texts.get(key);
  }

  private EditConflict compare(String field, boolean isSame, String shown) {
    if (isStale && !isSame) {
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
