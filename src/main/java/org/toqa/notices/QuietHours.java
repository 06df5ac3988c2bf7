package org.toqa.notices;

import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZonedDateTime;

/**
 * Hours of every day in which somebody is not to be disturbed.
 *
 * @param from their first moment
 * @param until the first moment after them; before {@code from}: of the next day; the same: all day
 * @param zone where they are counted
 */
public record QuietHours(LocalTime from, LocalTime until, ZoneId zone) {

  public boolean contains(Instant at) {
    LocalTime time = at.atZone(zone).toLocalTime();
    return from.isBefore(until)
        ? !time.isBefore(from) && time.isBefore(until)
        : !time.isBefore(from) || time.isBefore(until);
  }

  /** That moment, or the end of the quiet hours that it is in. */
  Instant endAfter(Instant at) {
    if (!contains(at)) {
      return at;
    }
    ZonedDateTime there = at.atZone(zone);
    ZonedDateTime end = there.toLocalDate().atTime(until).atZone(zone);
    return (end.isAfter(there) ? end : there.toLocalDate().plusDays(1).atTime(until).atZone(zone))
        .toInstant();
  }
}
