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
import org.toqa.web.Sites;

/**
 * Finds out whose request it is, and of which site he is; static files and the health are for
 * everybody, so there it does not ask. What pages ask by themselves while nobody sits before them
 * keeps no session alive.
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
      Credential.of(request).ifPresent(credential -> identify(credential, request));
    }
    chain.doFilter(request, response);
  }

  private static void identify(Credential credential, HttpServletRequest request) {
    Sites sites = Sites.of(request.getServletContext());
    boolean isBackground =
        request.getHeader(BACKGROUND_HEADER) != null || RequestPath.of(request).equals(LIVE_EVENTS);
    Optional<SessionStore.AuthenticatedSession> login =
        isBackground ? credential.loginWithoutUse(sites) : credential.login(sites);
    if (login.isPresent()) {
      Services own = sites.ofSecret(credential.secret());
      own.storeIn(request);
      new Caller(login.get().account(), login.get().session(), credential, own.site())
          .storeIn(request);
    }
  }
}
