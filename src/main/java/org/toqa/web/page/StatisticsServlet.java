package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.temporal.ChronoUnit;
import org.toqa.web.Tasks;

/** How the fleet does, from its newest tasks. */
public final class StatisticsServlet extends PageServlet {
  private static final int LOOKED_AT = 1000;

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Instant midnight =
        services()
            .fleet()
            .feed()
            .latest()
            .at()
            .atOffset(ZoneOffset.UTC)
            .truncatedTo(ChronoUnit.DAYS)
            .toInstant();
    Tasks tasks = new Tasks(services());
    request.setAttribute("statistics", TaskStatistics.of(tasks.newest(0, LOOKED_AT), midnight));
    request.setAttribute("count", tasks.count());
    show(request, response, "statistics");
  }
}
