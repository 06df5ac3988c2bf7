package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Optional;
import org.toqa.accounts.Session;
import org.toqa.accounts.SessionStore;
import org.toqa.web.Services;

/**
 * What a request shows to prove whose it is; asked again, it tells whether it still does.
 *
 * @param kind how it was shown
 */
public record Credential(Session.Kind kind, String secret) {

  /** The session it proves and its user, while it does and he may come in. */
  public Optional<SessionStore.AuthenticatedSession> login(Services services) {
    return services
        .sessions()
        .authenticate(kind, secret)
        .filter(login -> !login.account().disabled());
  }

  /** The request's bearer token if it has one, else its cookie if it has one. */
  public static Optional<Credential> of(HttpServletRequest request) {
    String authorization = request.getHeader("Authorization");
    if (authorization != null && authorization.regionMatches(true, 0, "Bearer ", 0, 7)) {
      return Optional.of(new Credential(Session.Kind.TOKEN, authorization.substring(7).strip()));
    }
    return SessionCookie.of(request).map(secret -> new Credential(Session.Kind.BROWSER, secret));
  }

  /** Without the secret, so that it reaches no log. */
  @Override
  public String toString() {
    return "Credential[" + kind + "]";
  }
}
