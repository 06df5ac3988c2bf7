package org.toqa.testbed;

import com.password4j.Argon2Function;
import com.password4j.Password;
import com.password4j.types.Argon2;

/**
 * Passwords hashed by the product's function at a small part of its cost. A hash says what it costs
 * to check it, and tests log in more often than they do anything else.
 */
public final class CheapPassword {
  private static final int MEMORY_KIB = 64;

  private CheapPassword() {}

  /** Its hash, as the product stores it. */
  public static String hash(String password) {
    return Password.hash(password)
        .addRandomSalt(16)
        .with(Argon2Function.getInstance(MEMORY_KIB, 1, 1, 32, Argon2.ID))
        .getResult();
  }
}
