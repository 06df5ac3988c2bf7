package org.toqa.web;

import jakarta.servlet.http.HttpServletRequest;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDate;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventArchive.Filter;
import org.toqa.web.access.Caller;

/** Reads from a request's query which events are wanted. */
public final class HistoryFilter {
  private static final String DAY = "\\d{4}-\\d{2}-\\d{2}";

  private final HttpServletRequest request;
  private final FieldErrors errors;

  public HistoryFilter(HttpServletRequest request, FieldErrors errors) {
    this.request = request;
    this.errors = errors;
  }

  /** It means something only when no error was filed. */
  public Filter read() {
    return new Filter(
        number("task"),
        text("robot"),
        text("user"),
        kind(),
        moment("from", 0),
        moment("until", 1),
        Caller.of(request).isManager());
  }

  /** The id of the event before which it begins. */
  public long before() {
    Long before = number("before");
    return before == null ? Long.MAX_VALUE : before;
  }

  private @Nullable String kind() {
    String kind = text("kind");
    if (kind != null && !kind.matches("[a-z]+(\\.[a-z-]+)?")) {
      errors.add("kind", Texts.of(request).get("error.history.kind"));
    }
    return kind;
  }

  private @Nullable Long number(String name) {
    String given = text(name);
    if (given == null) {
      return null;
    }
    String number = Digits.latin(given);
    if (!number.matches("[1-9][0-9]{0,17}")) {
      errors.add(name, Texts.of(request).get("error.history.number"));
      return null;
    }
    return Long.valueOf(number);
  }

  /** A moment with its offset from UTC, or a day in UTC, of which the end counts for an end. */
  private @Nullable Instant moment(String name, int daysLater) {
    String given = text(name);
    if (given == null) {
      return null;
    }
    try {
      return given.matches(DAY)
          ? LocalDate.parse(given).plusDays(daysLater).atStartOfDay(ZoneOffset.UTC).toInstant()
          : OffsetDateTime.parse(given).toInstant();
    } catch (DateTimeException e) {
      errors.add(name, Texts.of(request).get("error.history.moment"));
      return null;
    }
  }

  private @Nullable String text(String name) {
    String given = request.getParameter(name);
    return given == null || given.isBlank() ? null : given.strip();
  }
}
