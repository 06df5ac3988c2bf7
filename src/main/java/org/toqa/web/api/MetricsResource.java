package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.web.access.Caller;

/** What is measured, for Prometheus. */
public final class MetricsResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    response.setContentType("text/plain;version=0.0.4;charset=UTF-8");
    response
        .getWriter()
        .write(services(request).metrics().scrape(Caller.of(request).isAdministrator()));
  }
}
