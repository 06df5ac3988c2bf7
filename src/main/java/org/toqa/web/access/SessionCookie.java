package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Optional;
import org.toqa.accounts.Account;
import org.toqa.accounts.Secret;
import org.toqa.accounts.Session;
import org.toqa.web.Services;
import org.toqa.web.Sites;

/**
 * The secret that a browser keeps. That of somebody who is not signed in only ties forms to the
 * browser; whoever signs in gets a fresh one, so that one planted before is worth nothing.
 */
public final class SessionCookie {
  private static final String NAME = "toqa-session";

  private SessionCookie() {}

  static Optional<String> of(HttpServletRequest request) {
    return Cookies.values(request, NAME).filter(Secret::isWellFormed).findFirst();
  }

  /** The browser's secret; one that has none gets one. */
  static String getOrCreate(HttpServletRequest request, HttpServletResponse response) {
    return of(request)
        .orElseGet(
            () -> {
              String secret = Secret.random();
              set(request, response, secret);
              return secret;
            });
  }

  /**
   * Logs the user in, in this browser; what was logged in there ends.
   *
   * @param services of his site
   */
  public static void signIn(
      HttpServletRequest request, HttpServletResponse response, Services services, Account user) {
    signOut(request);
    set(
        request,
        response,
        services.sessions().begin(user, Session.Kind.BROWSER, RequestOrigin.of(request)).secret());
  }

  /** Logs out whoever is logged in, in this browser. */
  public static void signOut(HttpServletRequest request) {
    Sites sites = Sites.of(request.getServletContext());
    of(request).ifPresent(secret -> sites.ofSecret(secret).sessions().end(secret));
  }

  private static void set(HttpServletRequest request, HttpServletResponse response, String secret) {
    Cookies.add(request, response, "/", NAME, secret, Cookies.OF_SESSION);
  }
}
