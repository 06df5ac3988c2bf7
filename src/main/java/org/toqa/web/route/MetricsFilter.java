package org.toqa.web.route;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;

/** Measures how long requests take, but live events, which do not end. */
public final class MetricsFilter extends HttpFilter {
  private static final String NONE = "none";

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    long startedAt = System.nanoTime();
    try {
      chain.doFilter(request, response);
    } finally {
      if (!request.isAsyncStarted()) {
        measure(request, response.getStatus(), Duration.ofNanos(System.nanoTime() - startedAt));
      }
    }
  }

  private static void measure(HttpServletRequest request, int status, Duration time) {
    var route =
        Routes.find(RequestPath.of(request)).flatMap(place -> place.route(request.getMethod()));
    Services.of(request)
        .metrics()
        .recordRequest(
            route.map(Route::method).orElse(NONE),
            route.map(Route::path).orElse(NONE),
            status,
            time);
  }
}
