package org.toqa.fleet.history;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.time.temporal.ChronoUnit;
import java.time.temporal.TemporalAdjusters;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;

/**
 * Days of a time zone, cut into buckets. A day may have 23 or 25 hours there.
 *
 * @param from the first day
 * @param to the last day
 * @param borders where buckets begin, and where the last one ends
 */
public record Period(LocalDate from, LocalDate to, ZoneId zone, Step step, List<Instant> borders) {

  /** How long a bucket is; the first and the last one may be cut off by the period. */
  public enum Step {
    HOUR,
    DAY,
    /** From Monday on. */
    WEEK,
    MONTH;

    private static final int MAX_DAYS_IN_HOURS = 2;
    private static final int MAX_DAYS_IN_DAYS = 62;
    private static final int MAX_DAYS_IN_WEEKS = 190;

    static Step of(long days) {
      if (days <= MAX_DAYS_IN_HOURS) {
        return HOUR;
      }
      if (days <= MAX_DAYS_IN_DAYS) {
        return DAY;
      }
      return days <= MAX_DAYS_IN_WEEKS ? WEEK : MONTH;
    }

    private LocalDate nextBegin(LocalDate day) {
      return switch (this) {
        case HOUR, DAY -> day.plusDays(1);
        case WEEK -> day.with(TemporalAdjusters.next(DayOfWeek.MONDAY));
        case MONTH -> day.with(TemporalAdjusters.firstDayOfNextMonth());
      };
    }
  }

  public Period {
    borders = List.copyOf(borders);
  }

  /**
   * @param to not before {@code from}
   */
  public static Period of(LocalDate from, LocalDate to, ZoneId zone) {
    Step step = Step.of(ChronoUnit.DAYS.between(from, to) + 1);
    Instant end = to.plusDays(1).atStartOfDay(zone).toInstant();
    Stream<Instant> begins =
        step == Step.HOUR
            ? Stream.iterate(
                from.atStartOfDay(zone).toInstant(),
                hour -> hour.isBefore(end),
                hour -> hour.plus(Duration.ofHours(1)))
            : Stream.iterate(from, day -> !day.isAfter(to), step::nextBegin)
                .map(day -> day.atStartOfDay(zone).toInstant());
    // distinct: a zone that crossed the date line has a day of no length
    return new Period(
        from, to, zone, step, Stream.concat(begins, Stream.of(end)).distinct().toList());
  }

  public Instant begin() {
    return borders.getFirst();
  }

  /** The first moment after it. */
  public Instant end() {
    return borders.getLast();
  }

  /** How many buckets it is divided into, at least one. */
  public int bucketCount() {
    return borders.size() - 1;
  }

  /**
   * The bucket that the moment is in, counted from 0.
   *
   * @param moment within the period
   */
  public int bucketIndex(Instant moment) {
    int found = Collections.binarySearch(borders, moment);
    return found >= 0 ? found : -found - 2;
  }
}
