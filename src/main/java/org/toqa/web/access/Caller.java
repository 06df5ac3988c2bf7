package org.toqa.web.access;

import jakarta.servlet.ServletRequest;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;
import org.toqa.accounts.Session;

/** The user whose request it is, and how he proved it. */
public record Caller(Account account, Session session, Credential credential) {
  /** Also the name under which views find the caller. */
  private static final String ATTRIBUTE = "caller";

  public String name() {
    return account.name();
  }

  /**
   * @param owner the id of the account whose something is; null: nobody's
   */
  public boolean owns(@Nullable Long owner) {
    return owner != null && owner == account.id();
  }

  public boolean isManager() {
    return account.isManager();
  }

  /** Whether the caller may use a route that asks for that permission. */
  public boolean has(Permission permission) {
    return switch (permission) {
      case ANONYMOUS, SIGNED_IN -> true;
      case CLERK -> account.role() == Role.CLERK || isManager();
      case MANAGER -> isManager();
    };
  }

  void storeIn(ServletRequest request) {
    request.setAttribute(ATTRIBUTE, this);
  }

  /** The caller of a route that only who is signed in may use. */
  public static Caller of(ServletRequest request) {
    return Objects.requireNonNull((@Nullable Caller) request.getAttribute(ATTRIBUTE));
  }

  public static Optional<Caller> find(ServletRequest request) {
    return Optional.ofNullable((@Nullable Caller) request.getAttribute(ATTRIBUTE));
  }
}
