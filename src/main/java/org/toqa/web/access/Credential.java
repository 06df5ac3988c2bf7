package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Optional;
import org.toqa.accounts.Session;
import org.toqa.accounts.SessionStore;
import org.toqa.web.Sites;

/**
 * What a request shows to prove whose it is; asked again, it tells whether it still does.
 *
 * @param carrier how it was shown
 */
public record Credential(Session.Carrier carrier, String secret) {

  /**
   * The session it proves and its user, while it does and he may come in. It counts as use of the
   * session.
   */
  public Optional<SessionStore.AuthenticatedSession> login(Sites sites) {
    return sessions(sites)
        .authenticate(carrier, secret)
        .filter(login -> !login.account().disabled());
  }

  /** The same, but it counts as no use: the session ends as if nobody had asked. */
  public Optional<SessionStore.AuthenticatedSession> loginWithoutUse(Sites sites) {
    return sessions(sites).find(carrier, secret).filter(login -> !login.account().disabled());
  }

  private SessionStore sessions(Sites sites) {
    return sites.ofSecret(secret).sessions();
  }

  /** The request's bearer token if it has one, else its cookie if it has one. */
  public static Optional<Credential> of(HttpServletRequest request) {
    String authorization = request.getHeader("Authorization");
    if (authorization != null && authorization.regionMatches(true, 0, "Bearer ", 0, 7)) {
      return Optional.of(
          new Credential(Session.Carrier.BEARER, authorization.substring(7).strip()));
    }
    return SessionCookie.of(request).map(secret -> new Credential(Session.Carrier.COOKIE, secret));
  }

  /** Without the secret, so that it reaches no log. */
  @Override
  public String toString() {
    return "Credential[" + carrier + "]";
  }
}
