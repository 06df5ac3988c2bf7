package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Optional;

/**
 * Which site an administrator wants to look at: a program says so in a header of each request, a
 * browser keeps the site's id in a cookie.
 */
public final class VisitedSite {
  /** Has the site's name. */
  public static final String HEADER = "Toqa-Site";

  private static final String COOKIE = "toqa-site";

  private VisitedSite() {}

  /** The name that the request says, if it says any. */
  public static Optional<String> named(HttpServletRequest request) {
    return Optional.ofNullable(request.getHeader(HEADER)).map(String::strip);
  }

  /** The id that the browser keeps, if it keeps any. */
  public static Optional<Long> kept(HttpServletRequest request) {
    return Cookies.values(request, COOKIE)
        .filter(value -> value.matches("[1-9][0-9]{0,8}"))
        .map(Long::valueOf)
        .findFirst();
  }

  /** From now on the browser's pages show that site. */
  public static void keep(HttpServletRequest request, HttpServletResponse response, long site) {
    add(request, response, String.valueOf(site), Cookies.OF_SESSION);
  }

  /** From now on the browser's pages show the user's own site. */
  public static void forget(HttpServletRequest request, HttpServletResponse response) {
    if (kept(request).isPresent()) {
      add(request, response, "", Cookies.GONE);
    }
  }

  private static void add(
      HttpServletRequest request, HttpServletResponse response, String value, int maxAge) {
    Cookies.add(request, response, "/", COOKIE, value, maxAge);
  }
}
