package org.toqa.web.access;

import jakarta.servlet.http.Cookie;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;
import org.toqa.web.Language;

/** The language that a browser was told to keep to. */
public final class LanguageCookie {
  private static final String NAME = "toqa-language";
  private static final Duration LIFETIME = Duration.ofDays(365);

  private LanguageCookie() {}

  static Optional<Language> of(HttpServletRequest request) {
    Cookie[] cookies = request.getCookies();
    return (cookies == null ? Stream.<Cookie>empty() : Arrays.stream(cookies))
        .filter(cookie -> cookie.getName().equals(NAME))
        .flatMap(cookie -> Language.ofTag(cookie.getValue()).stream())
        .findFirst();
  }

  public static void set(
      HttpServletRequest request, HttpServletResponse response, Language language) {
    Cookie cookie = new Cookie(NAME, language.tag());
    cookie.setPath(request.getContextPath() + "/");
    cookie.setMaxAge(Math.toIntExact(LIFETIME.toSeconds()));
    cookie.setHttpOnly(true);
    cookie.setSecure(request.isSecure());
    cookie.setAttribute("SameSite", "Lax");
    response.addCookie(cookie);
  }
}
