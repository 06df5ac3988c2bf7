package org.toqa.fleet.history;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.history.Period.Step;

class PeriodTest {
  private static final ZoneId PARIS = ZoneId.of("Europe/Paris");

  @Test
  void daysBeginAtTheMidnightOfTheirZone() {
    Period period = Period.of(LocalDate.of(2026, 11, 20), LocalDate.of(2026, 11, 22), PARIS);

    assertEquals(
        List.of(
            Instant.parse("2026-11-19T23:00:00Z"), // an hour ahead of UTC in winter
            Instant.parse("2026-11-20T23:00:00Z"),
            Instant.parse("2026-11-21T23:00:00Z"),
            Instant.parse("2026-11-22T23:00:00Z")),
        period.borders());
  }

  @ParameterizedTest
  @CsvSource({"2026-03-29, 23", "2026-10-25, 25", "2026-11-21, 24"})
  void aDayHasTheHoursThatItsClockShows(LocalDate day, int hours) {
    Period inHours = Period.of(day, day, PARIS);
    Period inDays = Period.of(day.minusDays(1), day.plusDays(1), PARIS);

    assertEquals(hours, inHours.bucketCount());
    assertEquals(Duration.ofHours(1), lengths(inHours).getLast());
    assertEquals(
        List.of(Duration.ofHours(24), Duration.ofHours(hours), Duration.ofHours(24)),
        lengths(inDays));
  }

  @ParameterizedTest
  @CsvSource({
    "2026-11-20, 2026-11-21, HOUR, 48",
    "2026-11-19, 2026-11-21, DAY, 3",
    "2026-09-21, 2026-11-21, DAY, 62", // 10 of September, 31 of October, 21 of November
    "2026-09-20, 2026-11-21, WEEK, 10", // a Sunday, and nine weeks that begin on a Monday
    "2025-12-01, 2026-11-21, MONTH, 12",
    "2021-11-22, 2026-11-21, MONTH, 61"
  })
  void theLongerThePeriodTheLongerItsBuckets(LocalDate from, LocalDate to, Step step, int buckets) {
    Period period = Period.of(from, to, PARIS);

    assertEquals(step, period.step());
    assertEquals(buckets, period.bucketCount());
    assertEquals(from.atStartOfDay(PARIS).toInstant(), period.begin());
    assertEquals(to.plusDays(1).atStartOfDay(PARIS).toInstant(), period.end());
  }

  @Test
  void weeksBeginOnMondays() {
    Period period = Period.of(LocalDate.of(2026, 9, 16), LocalDate.of(2026, 11, 21), PARIS);

    assertEquals(Step.WEEK, period.step());
    assertEquals(
        LocalDate.of(2026, 9, 21).atStartOfDay(PARIS).toInstant(), period.borders().get(1));
  }

  @Test
  void aZoneThatLeftOutADayHasNoBucketForIt() {
    ZoneId samoa = ZoneId.of("Pacific/Apia"); // 2011-12-29 was followed by 2011-12-31

    Period period = Period.of(LocalDate.of(2011, 12, 28), LocalDate.of(2011, 12, 31), samoa);

    assertEquals(3, period.bucketCount());
  }

  @Test
  void aMomentIsInTheBucketThatBeginsWithIt() {
    Period period = Period.of(LocalDate.of(2026, 11, 20), LocalDate.of(2026, 11, 22), PARIS);

    assertEquals(0, period.bucketIndex(period.begin()));
    assertEquals(0, period.bucketIndex(period.borders().get(1).minusMillis(1)));
    assertEquals(1, period.bucketIndex(period.borders().get(1)));
    assertEquals(2, period.bucketIndex(period.end().minusMillis(1)));
  }

  private static List<Duration> lengths(Period period) {
    return IntStream.range(0, period.bucketCount())
        .mapToObj(i -> Duration.between(period.borders().get(i), period.borders().get(i + 1)))
        .toList();
  }
}
