package org.toqa.web;

import jakarta.servlet.ServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.text.MessageFormat;
import java.util.Locale;
import java.util.Objects;
import java.util.ResourceBundle;
import org.toqa.wording.Sentence;

/** All sentences and words that people read, in one language. */
public final class Texts {
  private static final String BUNDLE = "org.toqa.web.messages";
  private static final String ATTRIBUTE = Texts.class.getName();

  private final Locale locale;
  private final ResourceBundle bundle;

  private Texts(Locale locale, ResourceBundle bundle) {
    this.locale = locale;
    this.bundle = bundle;
  }

  public static Texts in(Locale locale) {
    return new Texts(
        locale,
        ResourceBundle.getBundle(
            BUNDLE,
            locale,
            ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES)));
  }

  /** The texts in the language of the request. */
  public static Texts of(ServletRequest request) {
    return (Texts) Objects.requireNonNull(request.getAttribute(ATTRIBUTE));
  }

  public void storeIn(ServletRequest request) {
    request.setAttribute(ATTRIBUTE, this);
  }

  /** Names the language in the answer's header. */
  public void setContentLanguage(HttpServletResponse response) {
    response.setHeader("Content-Language", locale.toLanguageTag());
  }

  public Locale locale() {
    return locale;
  }

  public ResourceBundle bundle() {
    return bundle;
  }

  public String get(String key, Object... values) {
    return new MessageFormat(bundle.getString(key), locale).format(values);
  }

  /** What the fleet says. */
  public String text(Sentence sentence) {
    return sentence.text(locale);
  }
}
