package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpSession;
import java.time.Duration;
import org.toqa.store.Account;

/** Begins and ends the sessions of users. */
public final class Sessions {
  /** Long enough for a shift. */
  private static final Duration IDLE = Duration.ofHours(12);

  private Sessions() {}

  /** A fresh session id and CSRF token, so that one planted before is worth nothing. */
  public static void begin(HttpServletRequest request, Account account) {
    HttpSession session = request.getSession();
    request.changeSessionId();
    CsrfToken.renew(session);
    Credential.SessionLogin.begin(session, account);
    session.setMaxInactiveInterval((int) IDLE.toSeconds());
  }

  public static void end(HttpServletRequest request) {
    HttpSession session = request.getSession(false);
    if (session != null) {
      session.invalidate();
    }
  }
}
