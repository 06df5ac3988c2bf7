package org.toqa.web;

import com.nulabinc.zxcvbn.Zxcvbn;
import java.util.List;

/**
 * What is tried first by whoever guesses: common passwords and names, rows of keys, repetitions.
 */
final class GuessablePasswords {
  /** Of the five grades of zxcvbn; one below it is found within a million guesses. */
  private static final int LEAST_SCORE = 2;

  /** Characters; an estimate takes longer than the square of them. */
  private static final int LOOKED_AT = 64;

  private static final Zxcvbn ESTIMATE = new Zxcvbn();

  private GuessablePasswords() {}

  static boolean contain(String password, String userName) {
    String beginning = password.substring(0, Math.min(password.length(), LOOKED_AT));
    return ESTIMATE.measure(beginning, List.of(userName, "toqa")).getScore() < LEAST_SCORE;
  }
}
