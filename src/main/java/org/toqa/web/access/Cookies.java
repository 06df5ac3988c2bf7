package org.toqa.web.access;

import jakarta.servlet.http.Cookie;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Arrays;
import java.util.stream.Stream;

/**
 * Cookies as all of these pages are: no script reads them, and no form of another site sends them.
 */
final class Cookies {
  /** Until the browser is closed. */
  static final int OF_SESSION = -1;

  /** The browser forgets it. */
  static final int GONE = 0;

  private Cookies() {}

  /** The values of that name that the request has. */
  static Stream<String> values(HttpServletRequest request, String name) {
    Cookie[] cookies = request.getCookies();
    return (cookies == null ? Stream.<Cookie>empty() : Arrays.stream(cookies))
        .filter(cookie -> cookie.getName().equals(name))
        .map(Cookie::getValue);
  }

  /**
   * @param path from the application's root, below which it is sent
   * @param maxAge seconds, or one of the constants
   */
  static void add(
      HttpServletRequest request,
      HttpServletResponse response,
      String path,
      String name,
      String value,
      int maxAge) {
    Cookie cookie = new Cookie(name, value);
    cookie.setPath(request.getContextPath() + path);
    cookie.setHttpOnly(true);
    cookie.setSecure(request.isSecure());
    cookie.setMaxAge(maxAge);
    cookie.setAttribute("SameSite", "Lax");
    response.addCookie(cookie);
  }
}
