package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.Locale;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PeriodStatistics;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.PeriodReader;

/** How the fleet does, in numbers of a period. */
public final class StatisticsPage extends PageHandler {

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    PeriodReader choice = new PeriodReader(request, errors);
    Period period = choice.period(services(request).clock().instant());
    String floor = wantedFloor(request, errors).floor();
    request.setAttribute("names", PeriodReader.NAMES);
    request.setAttribute("chosen", choice.name());
    if (!errors.isEmpty()) {
      showAgain(request, response, "statistics", errors);
      return;
    }
    PeriodStatistics figures = services(request).statistics().statistics(period, floor);
    Locale locale = Texts.of(request).locale();
    DateTimeFormatter day =
        DateTimeFormatter.ofLocalizedDate(FormatStyle.MEDIUM).withLocale(locale);
    request.setAttribute("period", period);
    request.setAttribute("firstDay", day.format(period.from()));
    request.setAttribute("lastDay", day.format(period.to()));
    request.setAttribute("total", figures.total());
    request.setAttribute("floorViews", services(request).fleet().snapshots().latest().floors());
    StatisticsCharts charts = new StatisticsCharts(figures, locale);
    request.setAttribute("series", charts.series());
    request.setAttribute("utilisation", charts.utilisation());
    show(request, response, "statistics");
  }
}
