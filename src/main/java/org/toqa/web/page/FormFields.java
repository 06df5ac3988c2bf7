package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.web.Texts;
import org.toqa.web.input.Digits;
import org.toqa.web.input.FieldErrors;

/** The fields of a form that somebody sent. An empty one counts as missing. */
final class FormFields {
  private final HttpServletRequest request;
  private final FieldErrors errors;

  FormFields(HttpServletRequest request, FieldErrors errors) {
    this.request = request;
    this.errors = errors;
  }

  @Nullable String text(String name) {
    String given = request.getParameter(name);
    return given == null || given.isBlank() ? null : given;
  }

  /** What was chosen of several. */
  List<String> texts(String name) {
    String[] given = request.getParameterValues(name);
    return given == null ? List.of() : List.of(given);
  }

  /** A field that holds no number gets a sentence and counts as missing. */
  @Nullable Double number(String name) {
    return number(name, name);
  }

  /**
   * @param shownAt the field that gets the sentence
   */
  @Nullable Double number(String name, String shownAt) {
    String given = text(name);
    if (given == null) {
      return null;
    }
    Optional<Double> number = Digits.number(given);
    if (number.isEmpty()) {
      errors.add(shownAt, Texts.of(request).get("error.notANumber"));
    }
    return number.orElse(null);
  }

  /**
   * A date and a time of day. One that is none gets a sentence and counts as missing.
   *
   * @param zone the field that names the time zone; where it is empty, UTC
   */
  @Nullable Instant moment(String name, String zone) {
    String given = text(name);
    if (given == null) {
      return null;
    }
    String place = text(zone);
    try {
      return LocalDateTime.parse(Digits.latin(given))
          .atZone(ZoneId.of(place == null ? "UTC" : place))
          .toInstant();
    } catch (DateTimeException e) {
      errors.add(name, Texts.of(request).get("error.notATime"));
      return null;
    }
  }
}
