package org.toqa.accounts;

import com.nulabinc.zxcvbn.Zxcvbn;
import java.util.List;

/**
 * What is tried first by whoever guesses: common passwords and names, rows of keys, repetitions.
 */
final class PasswordStrength {
  /** Of the five grades of zxcvbn; one below it is found within a million guesses. */
  private static final int MIN_SCORE = 2;

  /** Characters; an estimate takes longer than the square of them. */
  private static final int MAX_CHECKED_LENGTH = 64;

  private static final Zxcvbn ESTIMATOR = new Zxcvbn();

  private PasswordStrength() {}

  static boolean isGuessable(String password, String userName) {
    String beginning = password.substring(0, Math.min(password.length(), MAX_CHECKED_LENGTH));
    return ESTIMATOR.measure(beginning, List.of(userName, "toqa")).getScore() < MIN_SCORE;
  }
}
