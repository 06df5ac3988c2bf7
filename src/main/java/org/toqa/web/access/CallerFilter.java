package org.toqa.web.access;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.accounts.SessionStore;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;

/**
 * Finds out whose request it is; static files and the health are for everybody, so there it does
 * not ask. What pages ask by themselves while nobody sits before them keeps no session alive.
 */
public final class CallerFilter extends HttpFilter {
  /** In what a page asks by itself. */
  private static final String BACKGROUND_HEADER = "X-Toqa-Background";

  private static final String HEALTH = "/api/v1/health";
  private static final String LIVE_EVENTS = "/api/v1/events";

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    if (!request.getServletPath().startsWith("/assets/")
        && !RequestPath.of(request).equals(HEALTH)) {
      Credential.of(request)
          .flatMap(
              credential ->
                  login(credential, request)
                      .map(login -> new Caller(login.account(), login.session(), credential)))
          .ifPresent(caller -> caller.storeIn(request));
    }
    chain.doFilter(request, response);
  }

  private static Optional<SessionStore.AuthenticatedSession> login(
      Credential credential, HttpServletRequest request) {
    Services services = Services.of(request.getServletContext());
    boolean isBackground =
        request.getHeader(BACKGROUND_HEADER) != null || RequestPath.of(request).equals(LIVE_EVENTS);
    return isBackground ? credential.loginWithoutUse(services) : credential.login(services);
  }
}
