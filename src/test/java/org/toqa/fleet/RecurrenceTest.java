package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RecurrenceTest {
  private static final ZoneId BERLIN = ZoneId.of("Europe/Berlin");
  private static final Set<DayOfWeek> WORKDAYS = EnumSet.range(DayOfWeek.MONDAY, DayOfWeek.FRIDAY);

  @Test
  void onceIsDueOnce() {
    Instant at = Instant.parse("2026-11-21T10:00:00Z");
    Recurrence once = new Recurrence.Once(at);

    assertEquals(Optional.of(at), once.nextAfter(at.minusMillis(1)));
    assertEquals(Optional.empty(), once.nextAfter(at));
  }

  @ParameterizedTest
  @CsvSource({
    "2026-11-21T09:59:59Z, 2026-11-21T10:00:00Z",
    "2026-11-21T10:00:00Z, 2026-11-21T10:30:00Z",
    "2026-11-21T10:29:59Z, 2026-11-21T10:30:00Z",
    "2026-11-21T10:30:00Z, 2026-11-21T11:00:00Z",
    "2027-11-21T10:10:00Z, 2027-11-21T10:30:00Z"
  })
  void everyHalfHourCountsFromItsFirstTime(Instant moment, Instant next) {
    Recurrence every =
        new Recurrence.Every(Instant.parse("2026-11-21T10:00:00Z"), Duration.ofMinutes(30));

    assertEquals(Optional.of(next), every.nextAfter(moment));
  }

  /** Clocks in Berlin are set forward on 29 March 2026 and back on 25 October 2026. */
  @ParameterizedTest
  @CsvSource({
    "2026-11-20T06:59:59Z, 2026-11-20T07:00:00Z", // a Friday, 08:00 in winter
    "2026-11-20T07:00:00Z, 2026-11-23T07:00:00Z", // and then Monday
    "2026-03-27T07:00:00Z, 2026-03-30T06:00:00Z", // 08:00 in summer
    "2026-10-23T06:00:00Z, 2026-10-26T07:00:00Z" // and in winter again
  })
  void everyWeekdayAtEightIsEightByTheClock(Instant moment, Instant next) {
    Recurrence weekly = new Recurrence.Weekly(WORKDAYS, LocalTime.of(8, 0), BERLIN);

    assertEquals(Optional.of(next), weekly.nextAfter(moment));
  }

  @Test
  void aTimeThatClocksSkipIsLaterAndOneThatTheyShowTwiceIsDueOnce() {
    Recurrence sundays =
        new Recurrence.Weekly(Set.of(DayOfWeek.SUNDAY), LocalTime.of(2, 30), BERLIN);

    assertEquals(
        Optional.of(Instant.parse("2026-03-29T01:30:00Z")), // 03:30, since 02:30 is skipped
        sundays.nextAfter(Instant.parse("2026-03-28T12:00:00Z")));
    List<Instant> inAutumn =
        Stream.iterate(
                Instant.parse("2026-10-24T12:00:00Z"), at -> sundays.nextAfter(at).orElseThrow())
            .skip(1)
            .limit(2)
            .toList();
    assertEquals(
        List.of(
            Instant.parse("2026-10-25T00:30:00Z"), // 02:30 in summer time
            Instant.parse("2026-11-01T01:30:00Z")), // 02:30 in winter time
        inAutumn);
  }

  @Test
  void oneDayOfTheWeekComesBackAfterAWeek() {
    Recurrence mondays =
        new Recurrence.Weekly(Set.of(DayOfWeek.MONDAY), LocalTime.of(8, 0), ZoneId.of("UTC"));

    assertEquals(
        Optional.of(Instant.parse("2026-11-30T08:00:00Z")),
        mondays.nextAfter(Instant.parse("2026-11-23T08:00:00Z")));
  }
}
