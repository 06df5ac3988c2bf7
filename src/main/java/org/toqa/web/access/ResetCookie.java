package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Optional;
import org.toqa.accounts.Secret;

/**
 * The secret of a link by which a password is replaced, while its page is open: from there on it is
 * in no address, where history, logs and links to other pages would have it.
 */
public final class ResetCookie {
  private static final String NAME = "toqa-reset";

  private ResetCookie() {}

  public static Optional<String> of(HttpServletRequest request) {
    return Cookies.values(request, NAME).findFirst();
  }

  /**
   * @param secret as it was given; what cannot be one is not kept
   */
  public static void set(HttpServletRequest request, HttpServletResponse response, String secret) {
    add(request, response, Secret.isWellFormed(secret) ? secret : "none", Cookies.OF_SESSION);
  }

  public static void remove(HttpServletRequest request, HttpServletResponse response) {
    add(request, response, "", Cookies.GONE);
  }

  private static void add(
      HttpServletRequest request, HttpServletResponse response, String value, int maxAge) {
    Cookies.add(request, response, "/reset", NAME, value, maxAge);
  }
}
