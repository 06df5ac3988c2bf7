package org.toqa.web.route;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import org.toqa.web.ErrorResponse;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.access.Caller;

/**
 * Asks callers to wait who ask too fast: users by their name, others by their address. Static
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
    Services services = Services.of(request.getServletContext());
    Duration wait = services.requestLimit().tryAcquire(callerKey(request));
    if (wait.isZero()) {
      chain.doFilter(request, response);
      return;
    }
    services.metrics().recordRateLimited();
    long seconds = wait.plusMillis(999).toSeconds();
    response.setHeader("Retry-After", Long.toString(seconds));
    ErrorResponse.sendText(request, response, 429, "problem.tooManyRequests", seconds);
  }

  private static boolean isUnlimited(HttpServletRequest request) {
    return request.getServletPath().startsWith("/assets/")
        || RequestPath.of(request).equals(HEALTH);
  }

  private static String callerKey(HttpServletRequest request) {
    return Caller.find(request)
        .map(caller -> "user " + caller.name())
        .orElseGet(() -> "address " + request.getRemoteAddr());
  }
}
