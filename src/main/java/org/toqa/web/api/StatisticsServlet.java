package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.store.Period;
import org.toqa.store.PeriodFigures;
import org.toqa.web.FieldErrors;
import org.toqa.web.PeriodChoice;
import org.toqa.web.Services;

/** A period in numbers. */
public final class StatisticsServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, StatisticsJson.of(wanted(request, services())));
  }

  /**
   * @throws Problem.Raised when the query does not say a period
   */
  static PeriodFigures wanted(HttpServletRequest request, Services services) {
    FieldErrors errors = new FieldErrors();
    Period period = new PeriodChoice(request, errors).read(services.clock().instant());
    refuseIfAny(errors);
    return services.statistics().of(period);
  }
}
