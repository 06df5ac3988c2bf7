package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PeriodStatistics;
import org.toqa.web.Services;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.FloorQueryReader;
import org.toqa.web.input.PeriodReader;

/** A period in numbers. */
public final class StatisticsResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, StatisticsJson.of(figures(request, services(request))));
  }

  /**
   * @throws Problem.ProblemException when the query does not say a period
   */
  static PeriodStatistics figures(HttpServletRequest request, Services services) {
    FieldErrors errors = new FieldErrors();
    Period period = new PeriodReader(request, errors).period(services.clock().instant());
    String floor = new FloorQueryReader(request, errors, services.fleet().floors()).floor();
    throwIfAny(errors);
    return services.statistics().statistics(period, floor);
  }
}
