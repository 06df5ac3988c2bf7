package org.toqa.fleet;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** When something is due. */
public sealed interface Recurrence {

  /** The first moment after that one at which it is due, if there is one. */
  Optional<Instant> nextAfter(Instant moment);

  record Once(Instant at) implements Recurrence {
    @Override
    public Optional<Instant> nextAfter(Instant moment) {
      return Optional.of(at).filter(due -> due.isAfter(moment));
    }
  }

  /** From a first time on, again and again after the same time. */
  record Every(Instant first, Duration interval) implements Recurrence {
    @Override
    public Optional<Instant> nextAfter(Instant moment) {
      if (first.isAfter(moment)) {
        return Optional.of(first);
      }
      long passed = Duration.between(first, moment).dividedBy(interval);
      return Optional.of(first.plus(interval.multipliedBy(passed + 1)));
    }
  }

  /**
   * On days of the week at a time of day, as clocks show it in that zone. A time that they skip in
   * spring counts as much later; of one that they show twice in autumn the first counts.
   */
  record Weekly(Set<DayOfWeek> days, LocalTime time, ZoneId zone) implements Recurrence {
    public Weekly {
      days = Set.copyOf(days);
    }

    @Override
    public Optional<Instant> nextAfter(Instant moment) {
      LocalDate today = moment.atZone(zone).toLocalDate();
      return Stream.iterate(today, day -> day.plusDays(1))
          .limit(9) // today, a week, and a day for a zone that left one out
          .filter(day -> days.contains(day.getDayOfWeek()))
          .map(day -> day.atTime(time).atZone(zone).toInstant())
          .filter(due -> due.isAfter(moment))
          .findFirst();
    }
  }
}
