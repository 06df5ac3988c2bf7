package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PeriodStatistics;

/** A period in numbers, as a file for a spreadsheet. */
public final class StatisticsCsvResource extends ApiHandler {
  public static void series(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    PeriodStatistics statistics = StatisticsResource.figures(request, services(request));
    send(response, "series", statistics.period(), StatisticsCsv.series(statistics));
  }

  public static void robots(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    PeriodStatistics statistics = StatisticsResource.figures(request, services(request));
    send(response, "robots", statistics.period(), StatisticsCsv.robots(statistics));
  }

  private static void send(
      HttpServletResponse response, String content, Period period, CsvWriter csv)
      throws IOException {
    csv.send(response, "toqa-%s-%s-to-%s.csv".formatted(content, period.from(), period.to()));
  }
}
