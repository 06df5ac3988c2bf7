package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.toqa.web.Texts;

/** What holds for all views, scripts and texts. */
class ViewsTest {
  private static final Path WEBAPP = Path.of("src/main/webapp");
  private static final Path SOURCES = Path.of("src/main/java");

  /** The build fails where one cannot be compiled; the pages are served from what it made. */
  @Test
  void everyViewIsCompiled() throws IOException {
    Path servlets = Path.of("target/classes/org/apache/jsp/WEB_002dINF/views");

    assertEquals(
        files(WEBAPP.resolve("WEB-INF/views"), ".jsp").size(),
        files(servlets, "_jsp.class").size());
  }

  /** A key is used where it stands whole, or where its beginning stands before a value. */
  @Test
  void everyTextIsUsedAndEveryUsedTextIsThere() throws IOException {
    String all =
        Stream.of(views(), files(WEBAPP, ".js"), files(SOURCES, ".java"))
            .flatMap(List::stream)
            .map(ViewsTest::read)
            .collect(Collectors.joining("\n"));
    Set<String> keys = new TreeSet<>(Collections.list(Texts.in(Locale.ENGLISH).bundle().getKeys()));

    Set<String> unused =
        keys.stream()
            .filter(key -> !all.contains(key))
            .filter(key -> !isBuilt(key, all))
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(Set.of(), unused);

    Set<String> missing =
        Pattern.compile(
                "key=\"([a-zA-Z.0-9_]+)\"|(?:hint|label)=\"([a-zA-Z0-9]+\\.[a-zA-Z.0-9]+)\"")
            .matcher(all)
            .results()
            .map(found -> found.group(1) == null ? found.group(2) : found.group(1))
            .filter(key -> !keys.contains(key))
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(Set.of(), missing);
  }

  @Test
  void noViewSpeaksForItself() throws IOException {
    Pattern words =
        Pattern.compile(
            ">\\s*(?!autofocus)[A-Za-z]{2,}[^<>=${}]*<|\\s(?:aria-label|title|alt|placeholder)=\"[^\"$<]+\"");
    for (Path view : views()) {
      String markup = read(view).replaceAll("(?s)<%.*?%>", "");
      assertFalse(words.matcher(markup).find(), view + " has words that are not in the bundle");
    }
  }

  /** What a script shows it takes from the page's texts, by a key. */
  @Test
  void noScriptSpeaksForItself() throws IOException {
    String literal = "['\"`][^'\"`$]*[A-Za-z]{2}";
    String sentence = "['\"`][A-Z][a-z]+(?: [a-z]+)+[.!?]?['\"`]";
    Pattern words =
        Pattern.compile(
            "(?:textContent|innerText|innerHTML|ariaLabel|title|placeholder|alt)\\s*=\\s*"
                + literal
                + "|(?:setText|append|replaceChildren|fillText)"
                + "\\((?:(?:[^()'\"`,]|\\([^()]*\\))*,\\s*)?"
                + literal
                + "|createElement\\('[^']*', '[^']*', "
                + literal
                + "|drawLabel\\(\\w+, \\w+, "
                + literal
                + "|"
                + sentence);
    for (Path script : files(WEBAPP, ".js")) {
      String code = read(script).replaceAll("(?s)/\\*.*?\\*/", "").replaceAll("(?m)//.*$", "");
      assertFalse(words.matcher(code).find(), script + " has words that are not in the bundle");
    }
  }

  /** What people and robots call something is text, whatever it looks like. */
  @Test
  void noScriptMakesMarkupOfText() throws IOException {
    Pattern markup =
        Pattern.compile(
            "(?:inner|outer)HTML\\s*\\+?=[^=]|insertAdjacentHTML|createContextualFragment"
                + "|setHTML|srcdoc|document\\.write");
    for (Path script : files(WEBAPP, ".js")) {
      assertFalse(markup.matcher(read(script)).find(), script + " makes markup of a text");
    }
  }

  /** Style sheets for pages that run both ways name no left and no right. */
  @Test
  void theStyleSheetsAreLogical() throws IOException {
    String style =
        files(WEBAPP.resolve("assets/css"), ".css").stream()
            .map(ViewsTest::read)
            .collect(Collectors.joining("\n"));

    Pattern physical =
        Pattern.compile(
            "(?m)^\\s*((margin|padding|border)-)?(left|right)\\s*:|text-align:\\s*(left|right)");
    assertFalse(physical.matcher(style).find());
    assertTrue(style.contains("prefers-color-scheme: dark"));
  }

  private static List<Path> views() throws IOException {
    return Stream.of(files(WEBAPP, ".jsp"), files(WEBAPP, ".tag")).flatMap(List::stream).toList();
  }

  private static boolean isBuilt(String key, String all) {
    String stem = key.substring(0, key.lastIndexOf('.') + 1);
    return Stream.of("${", "\"").map(stem::concat).anyMatch(all::contains);
  }

  private static List<Path> files(Path under, String ending) throws IOException {
    try (Stream<Path> walk = Files.walk(under)) {
      return walk.filter(file -> file.toString().endsWith(ending)).sorted().toList();
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
