package org.toqa.web.access;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;

/** Tells the browser what this site never does, so that it refuses when somebody makes it. */
public final class SecurityHeadersFilter extends HttpFilter {
  private static final String CONTENT_SECURITY_POLICY =
      "default-src 'self'; img-src 'self' data:; object-src 'none'; base-uri 'none';"
          + " form-action 'self'; frame-ancestors 'none'";

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    setHeaders(response, request.isSecure());
    response.setHeader(
        "Cache-Control", request.getServletPath().startsWith("/assets/") ? "no-cache" : "no-store");
    chain.doFilter(request, response);
  }

  /** Those of every answer, also of one that no filter is asked for. */
  public static void setHeaders(HttpServletResponse response, boolean isSecure) {
    response.setHeader("Content-Security-Policy", CONTENT_SECURITY_POLICY);
    response.setHeader("X-Content-Type-Options", "nosniff");
    response.setHeader("X-Frame-Options", "DENY");
    response.setHeader("Referrer-Policy", "same-origin");
    response.setHeader("Cross-Origin-Opener-Policy", "same-origin");
    response.setHeader("Cross-Origin-Resource-Policy", "same-origin");
    if (isSecure) {
      response.setHeader("Strict-Transport-Security", "max-age=31536000");
    }
  }
}
