package org.toqa.accounts;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A user of the web application.
 *
 * @param name as it was typed; unique without regard to case
 * @param email where a link goes when the password is forgotten; null: nowhere
 * @param passwordHash with its parameters and salt; never shown
 * @param disabled whether he may not log in
 */
public record Account(
    long id,
    String name,
    @Nullable String email,
    String passwordHash,
    Role role,
    boolean disabled,
    Instant createdAt) {
  /** No account's id. */
  private static final long VISITOR = 0;

  public boolean isManager() {
    return role.isManager();
  }

  public boolean isAdministrator() {
    return role == Role.ADMINISTRATOR;
  }

  /** Whether he is of another site, and looks in. */
  public boolean isVisitor() {
    return id == VISITOR;
  }

  /**
   * The same as another site knows somebody who looks in: nothing there is his.
   *
   * @param from the name of his own site
   */
  public Account asVisitor(String from) {
    return new Account(VISITOR, name + "@" + from, null, passwordHash, role, disabled, createdAt);
  }

  /** Without the password's hash, so that it reaches no log. */
  @Override
  public String toString() {
    return "Account[" + id + ", " + name + ", " + role + "]";
  }
}
