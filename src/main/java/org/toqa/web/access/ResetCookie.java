package org.toqa.web.access;

import jakarta.servlet.http.Cookie;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;
import org.toqa.accounts.Secret;

/**
 * The secret of a link by which a password is replaced, while its page is open: from there on it is
 * in no address, where history, logs and links to other pages would have it.
 */
public final class ResetCookie {
  private static final String NAME = "toqa-reset";

  private ResetCookie() {}

  public static Optional<String> of(HttpServletRequest request) {
    Cookie[] cookies = request.getCookies();
    return (cookies == null ? Stream.<Cookie>empty() : Arrays.stream(cookies))
        .filter(cookie -> cookie.getName().equals(NAME))
        .map(Cookie::getValue)
        .findFirst();
  }

  /**
   * @param secret as it was given; what cannot be one is not kept
   */
  public static void set(HttpServletRequest request, HttpServletResponse response, String secret) {
    add(request, response, Secret.isWellFormed(secret) ? secret : "none", -1);
  }

  public static void remove(HttpServletRequest request, HttpServletResponse response) {
    add(request, response, "", 0);
  }

  private static void add(
      HttpServletRequest request, HttpServletResponse response, String value, int maxAge) {
    Cookie cookie = new Cookie(NAME, value);
    cookie.setPath(request.getContextPath() + "/reset");
    cookie.setHttpOnly(true);
    cookie.setSecure(request.isSecure());
    cookie.setMaxAge(maxAge);
    cookie.setAttribute("SameSite", "Lax");
    response.addCookie(cookie);
  }
}
