package org.toqa.web.input;

import java.time.DateTimeException;
import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Recurrence;
import org.toqa.web.Texts;

/**
 * What times of a schedule must be, whichever input they come by. Each method files a sentence
 * under the field when a value is missing or refused; what it then answers means nothing.
 */
public final class RecurrenceRules {
  private static final int MIN_MINUTES = 1;
  private static final int MAX_MINUTES = 366 * 24 * 60;

  private final Texts texts;
  private final FieldErrors errors;
  private final Instant now;

  public RecurrenceRules(Texts texts, FieldErrors errors, Instant now) {
    this.texts = texts;
    this.errors = errors;
    this.now = now;
  }

  public Recurrence once(String field, @Nullable Instant at) {
    return new Recurrence.Once(futureMoment(field, at));
  }

  public Recurrence every(
      String firstField, @Nullable Instant first, String minutesField, @Nullable Double minutes) {
    double given = minutes == null ? 0 : minutes;
    boolean isValid = given == Math.rint(given) && given >= MIN_MINUTES && given <= MAX_MINUTES;
    if (!isValid) {
      errors.add(minutesField, texts.get("error.schedule.minutes", MIN_MINUTES, MAX_MINUTES));
    }
    return new Recurrence.Every(
        futureMoment(firstField, first), Duration.ofMinutes(isValid ? (long) given : 1));
  }

  /**
   * @param days names of days in English, such as {@code MONDAY}
   * @param time hours and minutes
   */
  public Recurrence weekly(
      List<String> days, @Nullable String time, String zoneField, @Nullable String zone) {
    return new Recurrence.Weekly(days(days), time(time), zone(zoneField, zone));
  }

  /** The last moment, if there is one. */
  public @Nullable Instant until(String field, @Nullable Instant given) {
    return given == null ? null : futureMoment(field, given);
  }

  private Set<DayOfWeek> days(List<String> given) {
    Set<DayOfWeek> days = EnumSet.noneOf(DayOfWeek.class);
    for (String name : given) {
      Arrays.stream(DayOfWeek.values()).filter(d -> d.name().equals(name)).forEach(days::add);
    }
    if (days.isEmpty() || days.size() != given.size()) {
      errors.add("weekdays", texts.get("error.schedule.weekdays"));
    }
    return days;
  }

  private LocalTime time(@Nullable String given) {
    String time = given == null ? "" : Digits.latin(given);
    try {
      if (time.matches("\\d\\d:\\d\\d")) {
        return LocalTime.parse(time);
      }
    } catch (DateTimeException e) {
      // it gets the same sentence
    }
    errors.add("time", texts.get("error.schedule.time"));
    return LocalTime.MIDNIGHT;
  }

  private ZoneId zone(String field, @Nullable String given) {
    try {
      return ZoneId.of(given == null ? "" : given);
    } catch (DateTimeException e) {
      errors.add(field, texts.get("error.statistics.zone"));
      return ZoneId.of("UTC");
    }
  }

  private Instant futureMoment(String field, @Nullable Instant given) {
    if (given == null) {
      errors.add(field, texts.get("error.schedule.moment"));
      return now;
    }
    Instant checked = new InputRules(texts, errors).futureDeadline(field, given, now);
    return (checked == null ? now : checked).truncatedTo(ChronoUnit.MILLIS); // as it is stored
  }
}
