package org.toqa.accounts;

import java.util.Optional;

/**
 * What a password must be that somebody chooses: long enough to resist guessing, and none that is
 * tried first. Which characters it has is nobody's business.
 */
public final class PasswordRules {
  /** Characters. */
  public static final int MIN_LENGTH = 10;

  /** Characters. */
  public static final int MAX_LENGTH = 200;

  /** Why a password is refused. */
  public enum Violation {
    TOO_SHORT,
    TOO_LONG,
    SAME_AS_NAME,
    GUESSABLE
  }

  private PasswordRules() {}

  /** The first rule that the password breaks; empty: it is accepted. */
  public static Optional<Violation> violation(String password, String userName) {
    if (password.length() < MIN_LENGTH) {
      return Optional.of(Violation.TOO_SHORT);
    }
    if (password.length() > MAX_LENGTH) {
      return Optional.of(Violation.TOO_LONG);
    }
    if (password.equalsIgnoreCase(userName)) {
      return Optional.of(Violation.SAME_AS_NAME);
    }
    return PasswordStrength.isGuessable(password, userName)
        ? Optional.of(Violation.GUESSABLE)
        : Optional.empty();
  }
}
