package org.toqa.web.access;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.web.AllowedHosts;
import org.toqa.web.ErrorResponse;
import org.toqa.web.Services;

/**
 * Refuses requests to a name that is not this server's ({@link AllowedHosts}). Static files, which
 * the page that says so needs, are for everybody.
 */
public final class HostFilter extends HttpFilter {
  private static final int MISDIRECTED_REQUEST = 421;
  private static final int MAX_SHOWN_LENGTH = 100;

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    String host = request.getServerName();
    if (request.getServletPath().startsWith("/assets/")
        || isWithoutHost(request)
        || Services.of(request).allowedHosts().contains(host)) {
      chain.doFilter(request, response);
      return;
    }
    ErrorResponse.sendText(
        request,
        response,
        MISDIRECTED_REQUEST,
        "problem.host",
        host.substring(0, Math.min(host.length(), MAX_SHOWN_LENGTH)));
  }

  /** As programs of HTTP/1.0 may ask, and no browser does. */
  private static boolean isWithoutHost(HttpServletRequest request) {
    String host = request.getHeader("Host");
    return host == null || host.isBlank();
  }
}
