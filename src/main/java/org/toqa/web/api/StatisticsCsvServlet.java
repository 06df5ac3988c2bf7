package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PeriodStatistics;
import org.toqa.web.RequestPath;

/** A period in numbers, as a file for a spreadsheet. */
public final class StatisticsCsvServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    PeriodStatistics figures = StatisticsServlet.figures(request, services());
    boolean isOfRobots = RequestPath.lastSegment(request).equals("robots.csv");
    CsvWriter csv = isOfRobots ? StatisticsCsv.robots(figures) : StatisticsCsv.series(figures);
    Period period = figures.period();
    String name =
        "toqa-%s-%s-to-%s.csv"
            .formatted(isOfRobots ? "robots" : "series", period.from(), period.to());
    byte[] bytes = csv.toString().getBytes(StandardCharsets.UTF_8);
    response.setContentType("text/csv;header=present;charset=UTF-8");
    response.setHeader("Content-Disposition", "attachment; filename=\"" + name + "\"");
    response.setContentLength(bytes.length);
    response.getOutputStream().write(bytes);
  }
}
