package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.time.Duration;
import java.util.Optional;
import org.toqa.web.Language;

/** The language that a browser was told to keep to. */
public final class LanguageCookie {
  private static final String NAME = "toqa-language";
  private static final Duration LIFETIME = Duration.ofDays(365);

  private LanguageCookie() {}

  static Optional<Language> of(HttpServletRequest request) {
    return Cookies.values(request, NAME)
        .flatMap(value -> Language.ofTag(value).stream())
        .findFirst();
  }

  public static void set(
      HttpServletRequest request, HttpServletResponse response, Language language) {
    Cookies.add(
        request, response, "/", NAME, language.tag(), Math.toIntExact(LIFETIME.toSeconds()));
  }
}
