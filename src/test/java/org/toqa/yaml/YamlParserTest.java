package org.toqa.yaml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.OptionalInt;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class YamlParserTest {
  /** A bar begins a new line, an arrow is a tab. */
  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '`',
      value = {
        "port: 1|url: a: b; 2; a text with a colon in it stands in quotes",
        "port: 1|port: 2; 2; `port is there twice; leave one of them`",
        "port: 1|→url: a; 2; lines are indented by spaces, not by tabs",
        "port: @home; 1; a text that begins with @ stands in quotes",
        "port: 1|url|name: a; 3; after a key comes a colon and a space",
        "port: \"8080; 1; a quote is opened and not closed",
        "port: [1, 2; 1; a list in brackets is not closed with ]",
        "port: *other; 1; a text that begins with * stands in quotes",
        "port: !!java.net.URL [a]; 1; there are only texts, numbers, lists and keys",
      })
  void saysWhatToDo(String text, int line, String advice) {
    String yaml = text.replace('|', '\n').replace('→', '\t');
    YamlSyntaxException problem =
        assertThrows(YamlSyntaxException.class, () -> YamlParser.parse(yaml));
    assertEquals(advice, problem.problem());
    assertEquals(OptionalInt.of(line), problem.line());
  }

  @ParameterizedTest
  @ValueSource(strings = {"!!int abc", "!!float abc", "!!binary \"%\"", "!!timestamp x"})
  void aWordIsOfTheTypeThatItsTagNames(String word) {
    YamlSyntaxException problem =
        assertThrows(YamlSyntaxException.class, () -> YamlParser.parse("port: " + word));
    assertFalse(problem.problem().isBlank());
  }
}
