package org.toqa.web.access;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.jsp.jstl.core.Config;
import jakarta.servlet.jsp.jstl.fmt.LocalizationContext;
import java.io.IOException;
import org.toqa.web.Language;
import org.toqa.web.Texts;

/**
 * Chooses the language of the answer, for servlets and for views: the one that was chosen in this
 * browser, else the one that the browser asks for.
 */
public final class LanguageFilter extends HttpFilter {
  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    Language language =
        LanguageCookie.of(request)
            .orElseGet(() -> Language.preferred(request.getHeader("Accept-Language")));
    Texts texts = Texts.in(language.locale());
    texts.storeIn(request);
    Config.set(
        request,
        Config.FMT_LOCALIZATION_CONTEXT,
        new LocalizationContext(texts.bundle(), texts.locale()));
    request.setAttribute("language", language.tag());
    request.setAttribute("locale", texts.locale());
    request.setAttribute("languages", Language.values());
    request.setAttribute("direction", texts.get("language.direction"));
    if (!request.getServletPath().startsWith("/assets/")) {
      response.setHeader("Vary", "Accept-Language, Cookie");
    }
    chain.doFilter(request, response);
  }
}
