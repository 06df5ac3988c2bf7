package org.toqa.web.access;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;

/**
 * Finds out whose request it is; static files and the health are for everybody, so there it does
 * not ask.
 */
public final class CallerFilter extends HttpFilter {
  private static final String HEALTH = "/api/v1/health";

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    if (!request.getServletPath().startsWith("/assets/")
        && !RequestPath.of(request).equals(HEALTH)) {
      Credential.of(request)
          .flatMap(
              credential ->
                  credential
                      .login(Services.of(request.getServletContext()))
                      .map(login -> new Caller(login.account(), login.session(), credential)))
          .ifPresent(caller -> caller.storeIn(request));
    }
    chain.doFilter(request, response);
  }
}
