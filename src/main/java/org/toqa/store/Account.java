package org.toqa.store;

import java.time.Instant;

/**
 * A user of the web application.
 *
 * @param name as it was typed; unique without regard to case
 * @param passwordHash with its parameters and salt; never shown
 * @param disabled whether he may not log in
 */
public record Account(
    long id, String name, String passwordHash, Role role, boolean disabled, Instant createdAt) {

  public boolean isManager() {
    return role == Role.MANAGER;
  }

  /** Without the password's hash, so that it reaches no log. */
  @Override
  public String toString() {
    return "Account[" + id + ", " + name + ", " + role + "]";
  }
}
