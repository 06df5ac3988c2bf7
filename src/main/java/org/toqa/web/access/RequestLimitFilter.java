package org.toqa.web.access;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import org.toqa.web.Doors;
import org.toqa.web.Services;

/**
 * Asks callers to wait who ask too fast: users by their name, strangers by their address. Static
 * files, of which each page has many, and the health that monitors watch are for everybody.
 */
public final class RequestLimitFilter extends HttpFilter {
  private static final String HEALTH = "/api/v1/health";

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    if (isUnlimited(request)) {
      chain.doFilter(request, response);
      return;
    }
    Services services = Services.from(request.getServletContext());
    Duration wait = services.requestLimit().untilNext(caller(request));
    if (wait.isZero()) {
      chain.doFilter(request, response);
      return;
    }
    services.metrics().refusedAsTooFast();
    long seconds = wait.plusMillis(999).toSeconds();
    response.setHeader("Retry-After", Long.toString(seconds));
    Refusal.send(request, response, 429, "problem.tooFast", seconds);
  }

  private static boolean isUnlimited(HttpServletRequest request) {
    return request.getServletPath().startsWith("/assets/") || Doors.pathOf(request).equals(HEALTH);
  }

  private static String caller(HttpServletRequest request) {
    return Caller.ifKnown(request)
        .map(caller -> "user " + caller.name())
        .orElseGet(() -> "address " + request.getRemoteAddr());
  }
}
