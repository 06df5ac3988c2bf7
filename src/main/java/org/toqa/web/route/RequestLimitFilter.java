package org.toqa.web.route;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import org.toqa.accounts.AddressBlock;
import org.toqa.web.ErrorResponse;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.access.Caller;
import org.toqa.web.access.Credential;

/**
 * Asks callers to wait who ask too fast: users by their name, others by their address. Static
 * files, of which each page has many, and the health that monitors watch are for everybody.
 */
public final class RequestLimitFilter extends HttpFilter {
  private static final String HEALTH = "/api/v1/health";

  /** The attribute of a request that was counted by its address. */
  private static final String COUNTED = RequestLimitFilter.class.getName();

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    if (isUnlimited(request)) {
      chain.doFilter(request, response);
      return;
    }
    Optional<Caller> caller = Caller.find(request);
    Credential.of(request).ifPresent(shown -> remember(request, shown, caller.isPresent()));
    boolean isAnswered =
        caller.isPresent()
            ? tryAcquire(request, response, name(request, "user " + caller.get().uniqueName()))
            : request.getAttribute(COUNTED) != null || tryAcquireByAddress(request, response);
    if (isAnswered) {
      chain.doFilter(request, response);
    }
  }

  private static void remember(HttpServletRequest request, Credential shown, boolean isGood) {
    Services.of(request).requestLimit().setKnown(shown.secret(), isGood);
  }

  /** Counts the request for its address; false: it was answered that it has to wait. */
  static boolean tryAcquireByAddress(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    request.setAttribute(COUNTED, true);
    return tryAcquire(
        request, response, name(request, "address " + AddressBlock.of(request.getRemoteAddr())));
  }

  /** What is urgent is counted by itself, so that nothing else that he asks for uses it up. */
  private static String name(HttpServletRequest request, String caller) {
    return Routes.isUrgent(request) ? caller + " (urgent)" : caller;
  }

  private static boolean tryAcquire(
      HttpServletRequest request, HttpServletResponse response, String caller) throws IOException {
    Services services = Services.of(request);
    Duration wait = services.requestLimit().tryAcquire(caller);
    if (wait.isZero()) {
      return true;
    }
    services.metrics().recordRateLimited();
    long seconds = wait.plusMillis(999).toSeconds();
    response.setHeader("Retry-After", Long.toString(seconds));
    ErrorResponse.sendText(request, response, 429, "problem.tooManyRequests", seconds);
    return false;
  }

  static boolean isUnlimited(HttpServletRequest request) {
    return request.getServletPath().startsWith("/assets/")
        || RequestPath.of(request).equals(HEALTH);
  }
}
