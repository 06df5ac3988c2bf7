package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.Locale;
import org.toqa.store.Period;
import org.toqa.store.PeriodFigures;
import org.toqa.web.FieldErrors;
import org.toqa.web.PeriodChoice;
import org.toqa.web.Texts;

/** How the fleet does, in numbers of a period. */
public final class StatisticsServlet extends PageServlet {

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    PeriodChoice choice = new PeriodChoice(request, errors);
    Period period = choice.read(services().clock().instant());
    request.setAttribute("names", PeriodChoice.NAMES);
    request.setAttribute("chosen", choice.name());
    if (!errors.isEmpty()) {
      showAgain(request, response, "statistics", errors);
      return;
    }
    PeriodFigures figures = services().statistics().of(period);
    Locale locale = Texts.of(request).locale();
    DateTimeFormatter day =
        DateTimeFormatter.ofLocalizedDate(FormatStyle.MEDIUM).withLocale(locale);
    request.setAttribute("period", period);
    request.setAttribute("firstDay", day.format(period.from()));
    request.setAttribute("lastDay", day.format(period.to()));
    request.setAttribute("total", figures.total());
    StatisticsCharts charts = new StatisticsCharts(figures, locale);
    request.setAttribute("series", charts.series());
    request.setAttribute("use", charts.use());
    show(request, response, "statistics");
  }
}
