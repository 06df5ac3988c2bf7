package org.toqa.web;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;

/** Measures how long requests take, but live events, which do not end. */
public final class MetricsFilter extends HttpFilter {
  private static final String NONE = "none";

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    long begun = System.nanoTime();
    try {
      chain.doFilter(request, response);
    } finally {
      if (!request.isAsyncStarted()) {
        measure(request, response.getStatus(), Duration.ofNanos(System.nanoTime() - begun));
      }
    }
  }

  private static void measure(HttpServletRequest request, int status, Duration time) {
    var door = Doors.at(Doors.pathOf(request)).flatMap(place -> place.door(request.getMethod()));
    Services.from(request.getServletContext())
        .metrics()
        .answered(
            door.map(Door::method).orElse(NONE), door.map(Door::path).orElse(NONE), status, time);
  }
}
