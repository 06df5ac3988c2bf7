package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
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
    String name = "toqa-%s-%s-to-%s.csv".formatted(content, period.from(), period.to());
    byte[] bytes = csv.toString().getBytes(StandardCharsets.UTF_8);
    response.setContentType("text/csv;header=present;charset=UTF-8");
    response.setHeader("Content-Disposition", "attachment; filename=\"" + name + "\"");
    response.setContentLength(bytes.length);
    response.getOutputStream().write(bytes);
  }
}
