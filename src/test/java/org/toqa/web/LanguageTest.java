package org.toqa.web;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LanguageTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
                                   | ENGLISH
          ''                       | ENGLISH
          ar                       | ARABIC
          AR-eg                    | ARABIC
          ar-EG,ar;q=0.9,en;q=0.8  | ARABIC
          fr-FR,fr;q=0.9,ar;q=0.5  | ARABIC
          en-GB,ar;q=0.9           | ENGLISH
          ar;q=0.1,en;q=0.9        | ENGLISH
          ar;q=0,de                | ENGLISH
          de                       | ENGLISH
          *                        | ENGLISH
          ;q=1,,                   | ENGLISH
          ar;q=often               | ENGLISH
          <script>                 | ENGLISH
          """)
  void theBrowsersFirstLanguageThatIsSpokenIsTaken(@Nullable String accepted, Language language) {
    assertEquals(language, Language.preferred(accepted));
  }

  @Test
  void everyLanguageIsKnownByItsTag() {
    for (Language language : Language.values()) {
      assertEquals(language, Language.ofTag(language.tag()).orElseThrow());
    }
  }

  @ParameterizedTest
  @CsvSource({"AR", "ar-EG", "''", "messages"})
  void noOtherTagIsALanguage(String tag) {
    assertEquals(true, Language.ofTag(tag).isEmpty());
  }
}
