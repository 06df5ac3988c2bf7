package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpSession;
import java.util.Optional;
import org.toqa.store.Account;
import org.toqa.web.Services;

/** What a request shows to prove whose it is; asked again, it tells whether it still does. */
public sealed interface Credential {

  /** The user it proves, while it does and he may come in. */
  default Optional<Account> account(Services services) {
    return proven(services).filter(account -> !account.disabled());
  }

  /** The user it proves, while it does. */
  Optional<Account> proven(Services services);

  /** A session that ends with the user or with his password. */
  record SessionLogin(HttpSession session) implements Credential {
    private static final String USER_ID = "userId";
    private static final String PASSWORD_HASH = "passwordHash";

    /** Binds the session to the user. */
    public static void begin(HttpSession session, Account account) {
      session.setAttribute(USER_ID, account.id());
      session.setAttribute(PASSWORD_HASH, account.passwordHash());
    }

    @Override
    public Optional<Account> proven(Services services) {
      try {
        return session.getAttribute(USER_ID) instanceof Long id
            ? services
                .accounts()
                .byId(id)
                .filter(a -> a.passwordHash().equals(session.getAttribute(PASSWORD_HASH)))
            : Optional.empty();
      } catch (IllegalStateException sessionHasEnded) {
        return Optional.empty();
      }
    }
  }

  record BearerToken(String token) implements Credential {
    @Override
    public Optional<Account> proven(Services services) {
      return services.tokens().owner(token);
    }

    @Override
    public String toString() {
      return "BearerToken";
    }
  }

  /** The request's bearer token if it has one, else its session if it has one. */
  static Optional<Credential> of(HttpServletRequest request) {
    String authorization = request.getHeader("Authorization");
    if (authorization != null && authorization.regionMatches(true, 0, "Bearer ", 0, 7)) {
      return Optional.of(new BearerToken(authorization.substring(7).strip()));
    }
    return Optional.ofNullable(request.getSession(false)).map(SessionLogin::new);
  }
}
