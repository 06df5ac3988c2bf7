package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.web.Language;
import org.toqa.web.RequestPath;
import org.toqa.web.access.LanguageCookie;

/**
 * The switch on every page that chooses the language. It is a link, for it is also there where no
 * form may; it chooses nothing when another site leads here.
 */
public final class LanguageSwitch extends PageHandler {
  /** Segments from the address of a form to the page that has it, at most. */
  private static final int DEEPEST_FORM = 3;

  public static void choose(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Optional<Language> chosen = Language.ofTag(RequestPath.parameter(request, "language"));
    if (chosen.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchPage");
      return;
    }
    if (!"cross-site".equals(request.getHeader("Sec-Fetch-Site"))) {
      LanguageCookie.set(request, response, chosen.get());
    }
    redirect(request, response, returnPage(request, request.getParameter("back")));
  }

  /** Where a refused form was shown again, the page that has it. */
  private static String returnPage(HttpServletRequest request, @Nullable String address) {
    return Stream.iterate(Objects.requireNonNullElse(address, ""), LanguageSwitch::parentPath)
        .limit(1 + DEEPEST_FORM)
        .flatMap(at -> ReturnAddress.parse(request, at).stream())
        .findFirst()
        .orElse("/");
  }

  private static String parentPath(String address) {
    return address.substring(0, Math.max(0, address.lastIndexOf('/')));
  }
}
