package org.toqa.testbed;

import org.toqa.accounts.PasswordHasher;

/**
 * Passwords hashed by the product's function at a small part of its cost. A hash says what it costs
 * to check it, and tests log in more often than they do anything else.
 */
public final class CheapPassword {
  private static final PasswordHasher HASHER = hasher();

  private CheapPassword() {}

  /** For a server of a test. */
  public static PasswordHasher hasher() {
    return new PasswordHasher(64, 1);
  }

  /** Its hash, as the product stores it. */
  public static String hash(String password) {
    return HASHER.hash(password);
  }
}
