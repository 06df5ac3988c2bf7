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

  public boolean isManager() {
    return role == Role.MANAGER;
  }

  /** Without the password's hash, so that it reaches no log. */
  @Override
  public String toString() {
    return "Account[" + id + ", " + name + ", " + role + "]";
  }
}
