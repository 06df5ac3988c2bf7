package org.toqa.web.access;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.jsp.jstl.core.Config;
import jakarta.servlet.jsp.jstl.fmt.LocalizationContext;
import java.io.IOException;
import java.util.Locale;
import org.toqa.web.Texts;

/** Chooses the language of the answer, for servlets and for views. */
public final class LanguageFilter extends HttpFilter {
  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    Texts texts = Texts.in(Locale.ENGLISH);
    texts.keepIn(request);
    Config.set(
        request,
        Config.FMT_LOCALIZATION_CONTEXT,
        new LocalizationContext(texts.bundle(), texts.locale()));
    request.setAttribute("language", texts.locale().toLanguageTag());
    request.setAttribute("direction", texts.get("language.direction"));
    chain.doFilter(request, response);
  }
}
