package org.toqa.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CleanTextTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "two\nlines",
        "two\r\nlines",
        "two\u2028lines",
        "two\u0085lines",
        "two\u001b[31m\nlines",
        "two\u001b]0;title\u0007\nlines",
        "two\u0000\u0007\u007flines",
        "two\u202e\u2066\u200f\ufefflines"
      })
  void whatIsNoTextBecomesABlank(String foreign) {
    assertEquals("two lines", CleanText.of(foreign));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\u001b[1;31mred\u001b[0m",
        "\u009b31mred",
        "\u001b]8;;http://x\u001b\\red",
        "\u001bcred"
      })
  void terminalsAreToldNothing(String foreign) {
    assertEquals("red", CleanText.of(foreign));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "r1 stands.",
        "\u0645\u0648\u0642\u0641",
        "\u0645\u06cc\u200c\u062e",
        "50 \u00b0C \ud83e\udd16"
      })
  void whatIsTextStays(String foreign) {
    assertEquals(foreign, CleanText.of(foreign));
  }

  @Test
  void whatIsTooLongIsCut() {
    assertEquals("x".repeat(500) + "...", CleanText.of("x".repeat(501)));
    assertEquals("x".repeat(500), CleanText.of("x".repeat(500)));
    assertEquals("ab...", CleanText.of("ab\ud83e\udd16c", 3));
  }

  @Test
  void halfACharacterIsNone() {
    assertEquals("a b", CleanText.of("a\ud83eb"));
  }
}
