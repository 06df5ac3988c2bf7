package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDate;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.FloorMap;
import org.toqa.web.Texts;

/**
 * The fields of a request's query. One that is empty counts as missing, as does one that is refused
 * with a sentence.
 */
final class QueryFields {
  private static final String DAY = "\\d{4}-\\d{2}-\\d{2}";

  private final HttpServletRequest request;
  private final FieldErrors errors;

  QueryFields(HttpServletRequest request, FieldErrors errors) {
    this.request = request;
    this.errors = errors;
  }

  /** The moment {@code from}; a day counts from its begin. */
  @Nullable Instant from() {
    return moment("from", 0);
  }

  /** The moment {@code until}; a day counts to its end. */
  @Nullable Instant until() {
    return moment("until", 1);
  }

  /**
   * The floor that is wanted alone; null: all.
   *
   * @param floors those that there are
   */
  @Nullable String floor(List<FloorMap> floors) {
    String given = text("floor");
    if (given != null && floors.stream().noneMatch(floor -> floor.name().equals(given))) {
      String names = floors.stream().map(FloorMap::name).collect(Collectors.joining(", "));
      errors.add("floor", Texts.of(request).get("problem.noSuchFloor", names));
      return null;
    }
    return given;
  }

  @Nullable Long number(String name) {
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

  @Nullable String text(String name) {
    String given = request.getParameter(name);
    return given == null || given.isBlank() ? null : given.strip();
  }
}
