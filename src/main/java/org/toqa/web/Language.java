package org.toqa.web;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** The languages that people can choose. The first one is spoken to whoever reads none of them. */
public enum Language {
  ENGLISH("en"),
  ARABIC("ar");

  private static final List<Locale> LOCALES =
      Arrays.stream(values()).map(Language::locale).toList();

  private final Locale locale;

  Language(String tag) {
    this.locale = Locale.forLanguageTag(tag);
  }

  public Locale locale() {
    return locale;
  }

  /** As pages, cookies and headers name it. */
  public String tag() {
    return locale.toLanguageTag();
  }

  public static Optional<Language> ofTag(@Nullable String tag) {
    return Arrays.stream(values()).filter(language -> language.tag().equals(tag)).findFirst();
  }

  /** The one that the header Accept-Language likes best. */
  public static Language preferred(@Nullable String accepted) {
    if (accepted == null) {
      return ENGLISH;
    }
    try {
      Locale best = Locale.lookup(Locale.LanguageRange.parse(accepted), LOCALES);
      return best == null ? ENGLISH : values()[LOCALES.indexOf(best)];
    } catch (IllegalArgumentException e) {
      return ENGLISH; // not a list of languages
    }
  }
}
