package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.history.EventArchive.Filter;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** Reads from a request's query which events are wanted. */
public final class HistoryQueryReader {
  private final HttpServletRequest request;
  private final FieldErrors errors;
  private final QueryFields fields;

  public HistoryQueryReader(HttpServletRequest request, FieldErrors errors) {
    this.request = request;
    this.errors = errors;
    this.fields = new QueryFields(request, errors);
  }

  /** It means something only when no error was filed. */
  public Filter filter() {
    return new Filter(
        fields.number("task"),
        fields.text("robot"),
        fields.text("user"),
        kind(),
        fields.from(),
        fields.until(),
        Caller.of(request).isManager(),
        Caller.of(request).isAdministrator(),
        fields.text("floor"));
  }

  /** The id of the event before which it begins. */
  public long before() {
    Long before = fields.number("before");
    return before == null ? Long.MAX_VALUE : before;
  }

  private @Nullable String kind() {
    String kind = fields.text("kind");
    if (kind != null && !EventKind.isKnown(kind)) {
      errors.add("kind", Texts.of(request).get("error.history.kind"));
    }
    return kind;
  }
}
