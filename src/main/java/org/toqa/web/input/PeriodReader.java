package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.history.Period;
import org.toqa.web.Texts;

/**
 * Reads from a request's query which period is wanted: one that has a name, or days {@code from}
 * and {@code to}, which go before it; in the time zone {@code zone}.
 */
public final class PeriodReader {
  /** What {@code period} may be. */
  public static final List<String> NAMES = List.of("today", "7d", "30d", "12m");

  private static final ZoneId UTC = ZoneId.of("UTC");
  private static final String DEFAULT = "7d";
  private static final LocalDate EARLIEST = LocalDate.of(2000, 1, 1);
  private static final LocalDate LATEST = LocalDate.of(9998, 12, 31);
  private static final int MAX_YEARS = 5;

  private final HttpServletRequest request;
  private final FieldErrors errors;

  public PeriodReader(HttpServletRequest request, FieldErrors errors) {
    this.request = request;
    this.errors = errors;
  }

  /** The name of the wanted period; empty where its days are given. */
  public String name() {
    String name = text("period");
    if (hasDays()) {
      return "";
    }
    return name == null ? DEFAULT : name;
  }

  /** It means something only when no error was filed. */
  public Period period(Instant now) {
    ZoneId zone = zone();
    LocalDate today = now.atZone(zone).toLocalDate();
    return hasDays()
        ? between(day("from", today), day("to", today), zone)
        : Period.of(firstDay(today), today, zone);
  }

  private boolean hasDays() {
    return text("from") != null || text("to") != null;
  }

  private LocalDate firstDay(LocalDate today) {
    return switch (name()) {
      case "today" -> today;
      case "7d" -> today.minusDays(6);
      case "30d" -> today.minusDays(29);
      case "12m" -> today.withDayOfMonth(1).minusMonths(11);
      default -> {
        refuse("period", "error.statistics.period", String.join(", ", NAMES));
        yield today;
      }
    };
  }

  private Period between(LocalDate from, LocalDate to, ZoneId zone) {
    if (to.isBefore(from)) {
      refuse("to", "error.statistics.order");
    } else if (!to.isBefore(from.plusYears(MAX_YEARS))) {
      refuse("to", "error.statistics.long", MAX_YEARS);
    } else {
      return Period.of(from, to, zone);
    }
    return Period.of(from, from, zone);
  }

  private LocalDate day(String name, LocalDate fallback) {
    String given = text(name);
    try {
      LocalDate day = LocalDate.parse(given == null ? "" : given);
      if (!day.isBefore(EARLIEST) && !day.isAfter(LATEST)) {
        return day;
      }
    } catch (DateTimeException e) {
      // said below
    }
    refuse(name, "error.statistics.day");
    return fallback;
  }

  private ZoneId zone() {
    String given = text("zone");
    try {
      return given == null ? UTC : ZoneId.of(given);
    } catch (DateTimeException e) {
      refuse("zone", "error.statistics.zone");
      return UTC;
    }
  }

  private @Nullable String text(String name) {
    String given = request.getParameter(name);
    return given == null || given.isBlank() ? null : given.strip();
  }

  private void refuse(String field, String key, Object... values) {
    errors.add(field, Texts.of(request).get(key, values));
  }
}
