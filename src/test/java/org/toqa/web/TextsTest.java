package org.toqa.web;

import static java.util.stream.Collectors.toCollection;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiPredicate;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.testbed.TextFile;

/** The texts of one language against those of the other. */
class TextsTest {
  private static final Path FOLDER = Path.of("src/main/resources/org/toqa/web");
  private static final Map<String, String> ENGLISH =
      TextFile.read(FOLDER.resolve("messages.properties"));
  private static final Map<String, String> ARABIC =
      TextFile.read(FOLDER.resolve("messages_ar.properties"));

  /** The product's name, what the languages call themselves, and what is written alike. */
  private static final Set<String> ALIKE =
      Set.of(
          "language.en",
          "language.ar",
          "product.name",
          "newTask.deadline.utc",
          "robot.letter.ERROR",
          "statistics.none");

  private static final Pattern PLACEHOLDER = Pattern.compile("\\{(\\d)");
  private static final Texts IN_ARABIC = Texts.in(Language.ARABIC.locale());

  @Test
  void noTextIsMissing() {
    assertEquals(Set.of(), without(ENGLISH.keySet(), ARABIC.keySet()), "not in Arabic");
    assertEquals(Set.of(), without(ARABIC.keySet(), ENGLISH.keySet()), "only in Arabic");
  }

  @Test
  void textsStandInTheSameOrder() {
    assertEquals(List.copyOf(ENGLISH.keySet()), List.copyOf(ARABIC.keySet()));
  }

  @Test
  void noTextIsEmpty() {
    assertEquals(Set.of(), keysWhere((english, arabic) -> english.isBlank() || arabic.isBlank()));
  }

  @Test
  void everyTextIsTranslated() {
    assertEquals(new TreeSet<>(ALIKE), keysWhere(String::equals));
  }

  @Test
  void translationsHaveTheSamePlaceholders() {
    assertEquals(
        Set.of(),
        keysWhere((english, arabic) -> !placeholders(english).equals(placeholders(arabic))));
  }

  /** MessageFormat would swallow it and all that follows. */
  @Test
  void noTextHasAnAsciiApostrophe() {
    assertEquals(
        Set.of(), keysWhere((english, arabic) -> english.contains("'") || arabic.contains("'")));
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void everyTextIsAMessage(Language language) {
    Map<String, String> texts = language == Language.ENGLISH ? ENGLISH : ARABIC;
    texts.forEach(
        (key, text) -> {
          String shown = new MessageFormat(text, language.locale()).format(new Object[] {7, 7, 7});
          assertFalse(shown.contains("{"), key);
        });
  }

  /** What is isolated from the direction of the text ends somewhere. */
  @Test
  void everyIsolationEnds() {
    ARABIC.forEach(
        (key, text) -> assertEquals(count(text, "[\u2066\u2068]"), count(text, "\u2069"), key));
  }

  /** Arabic counts none, one and two in words of their own. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          0    | لا توجد مهام بعد
          1    | مهمة واحدة
          2    | مهمتان
          3    | عدد المهام: 3
          11   | عدد المهام: 11
          1234 | عدد المهام: 1,234
          """)
  void tasksAreCountedAsArabicCounts(long count, String sentence) {
    assertEquals(sentence, IN_ARABIC.get("tasks.count", count));
  }

  @ParameterizedTest
  @CsvSource({"1, ساعة", "2, ساعتين", "4, 4 ساعات", "10, 10 ساعات", "11, 11 ساعة", "24, 24 ساعة"})
  void hoursAreCountedAsArabicCounts(int hours, String counted) {
    assertEquals("أثر الروبوت في آخر " + counted, IN_ARABIC.get("robot.track", hours));
  }

  @Test
  void digitsAreWesternInBothLanguages() {
    assertEquals("1,234.5 kg", Texts.in(Locale.ENGLISH).get("common.kilograms", 1234.5));
    assertEquals("1,234.5 كغم", IN_ARABIC.get("common.kilograms", 1234.5));
  }

  @Test
  void aLanguageThatIsNotSpokenIsEnglish() {
    assertTrue(Texts.in(Locale.FRENCH).get("login.title").contains("Log in"));
  }

  private static Set<String> keysWhere(BiPredicate<String, String> isSo) {
    return ENGLISH.keySet().stream()
        .filter(ARABIC::containsKey)
        .filter(key -> isSo.test(ENGLISH.get(key), ARABIC.get(key)))
        .collect(toCollection(TreeSet::new));
  }

  private static Set<String> placeholders(String text) {
    return PLACEHOLDER
        .matcher(text)
        .results()
        .map(found -> found.group(1))
        .collect(toCollection(TreeSet::new));
  }

  private static Set<String> without(Set<String> keys, Set<String> others) {
    Set<String> rest = new TreeSet<>(keys);
    rest.removeAll(others);
    return rest;
  }

  private static long count(String text, String regex) {
    return Pattern.compile(regex).matcher(text).results().map(MatchResult::group).count();
  }
}
