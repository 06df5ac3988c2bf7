package org.toqa.wording;

import static java.util.stream.Collectors.joining;
import static java.util.stream.Collectors.toCollection;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.toqa.geometry.Vec2;
import org.toqa.testbed.TextFile;

/** The phrases in both languages, and how sentences are read. */
class SentenceTest {
  private static final Path FOLDER = Path.of("src/main/resources/org/toqa/wording");
  private static final Path SOURCES = Path.of("src/main/java/org/toqa");
  private static final Map<String, String> ENGLISH =
      TextFile.read(FOLDER.resolve("sentences.properties"));
  private static final Map<String, String> ARABIC =
      TextFile.read(FOLDER.resolve("sentences_ar.properties"));
  private static final Locale IN_ARABIC = Locale.of("ar");

  private static final Pattern PLACE = Pattern.compile("\\{(\\d)(,number|,choice)?");

  private static final Pattern LATIN = Pattern.compile("[A-Za-z]{2,}");

  static List<Map<String, String>> languages() {
    return List.of(ENGLISH, ARABIC);
  }

  @ParameterizedTest
  @MethodSource("languages")
  void everyPhraseIsThereAndNoOther(Map<String, String> texts) {
    assertEquals(
        Arrays.stream(Phrase.values()).map(Phrase::name).toList(), List.copyOf(texts.keySet()));
  }

  /** What {@link Sentence} itself is made of. */
  private static final Set<Phrase> OF_SENTENCE =
      Set.of(
          Phrase.AS_SAID,
          Phrase.POINT,
          Phrase.MINUTES_AND_SECONDS,
          Phrase.HOURS_AND_MINUTES,
          Phrase.DAYS_AND_HOURS);

  @Test
  void everyPhraseIsUsed() {
    String sources = sources();
    assertEquals(
        List.of(),
        Arrays.stream(Phrase.values())
            .filter(phrase -> !sources.contains("Phrase." + phrase.name()))
            .filter(phrase -> !OF_SENTENCE.contains(phrase))
            .toList());
  }

  @ParameterizedTest
  @EnumSource(Phrase.class)
  void bothLanguagesHaveTheSamePlaces(Phrase phrase) {
    List<String> english = places(ENGLISH, phrase);
    assertEquals(english, places(ARABIC, phrase));
    assertEquals( // from the first one on
        english.stream().map(place -> place.charAt(0) - '0').distinct().toList(),
        Stream.iterate(0, i -> i + 1).limit(english.size()).toList());
  }

  @ParameterizedTest
  @EnumSource(Phrase.class)
  void everyPhraseIsRead(Phrase phrase) {
    List<String> places = places(ENGLISH, phrase);
    Sentence sentence =
        phrase.with(places.stream().map(place -> place.length() == 1 ? "r1" : 7777L).toArray());

    assertTrue(sentence.isComplete());
    for (String read : List.of(sentence.english(), sentence.text(IN_ARABIC))) {
      assertFalse(read.contains("{"), read);
      assertFalse(read.contains("7,777"), read);
      assertEquals(
          places.stream().anyMatch(p -> p.endsWith("number")), read.contains("7777"), read);
    }
  }

  @Test
  void noPhraseHasAnAsciiApostrophe() {
    assertEquals(List.of(), keys(text -> text.contains("'")));
  }

  @Test
  void everyIsolationEnds() {
    ARABIC.forEach(
        (key, text) -> assertEquals(count(text, "[\u2066\u2068]"), count(text, "\u2069"), key));
  }

  @Test
  void arabicHasNoEnglishWord() {
    assertEquals(
        List.of(),
        ARABIC.entrySet().stream()
            .filter(
                e ->
                    LATIN
                        .matcher(
                            e.getValue()
                                .replaceAll("\u2066[^\u2069]*\u2069", "")
                                .replaceAll("\\{[^}]*\\}", ""))
                        .find())
            .map(Map.Entry::getKey)
            .toList());
  }

  @Test
  void aSentenceIsReadWithAllItsParts() {
    Sentence sentence =
        Phrase.WITH_LOAD.with(
            Phrase.ROBOT_AND_CLAUSE.with("r1", Phrase.IS_NOT_HEARD_OF.with()),
            Phrase.AT_PLACE.with(Sentence.of(new Vec2(-2, 12.3))));

    assertEquals("r1 is lost with the load on board, at (-2.00, 12.30)", sentence.english());
    assertEquals(
        "\u2068r1\u2069 مفقود والحمولة على متنه، عند \u2066(\u200e-2.00, 12.30)\u2069",
        sentence.text(IN_ARABIC));
  }

  @Test
  void namesStandOneAfterTheOther() {
    assertEquals("r1", Sentence.names(List.of("r1")).english());
    assertEquals("r1, r2, {0}", Sentence.names(List.of("r1", "r2", "{0}")).english());
    assertEquals(
        "\u2068r1\u2069، \u2068r2\u2069", Sentence.names(List.of("r1", "r2")).text(IN_ARABIC));
  }

  @Test
  void whatLacksAValueCannotBeSaid() {
    assertFalse(Phrase.HAS_PARKED.with().isComplete());
    assertFalse(Phrase.HAS_PARKED.with("r1", "r2").isComplete());
    assertFalse(Phrase.TASK_ON_HOLD.with("seven").isComplete());
    assertFalse(Phrase.LOST.with(Phrase.HAS_PARKED.with(), "r1").isComplete());
  }

  private static List<String> places(Map<String, String> texts, Phrase phrase) {
    return PLACE
        .matcher(texts.getOrDefault(phrase.name(), ""))
        .results()
        .map(found -> found.group(2) == null ? found.group(1) : found.group(1) + ",number")
        .collect(toCollection(TreeSet::new))
        .stream()
        .toList();
  }

  private static List<String> keys(Predicate<String> isSo) {
    return Arrays.stream(Phrase.values())
        .map(Phrase::name)
        .filter(key -> languages().stream().anyMatch(texts -> isSo.test(texts.get(key))))
        .toList();
  }

  private static long count(String text, String regex) {
    return Pattern.compile(regex).matcher(text).results().map(MatchResult::group).count();
  }

  private static String sources() {
    try (Stream<Path> files = Files.walk(SOURCES)) {
      return files
          .filter(file -> file.toString().endsWith(".java"))
          .filter(file -> !file.startsWith(SOURCES.resolve("wording")))
          .map(SentenceTest::read)
          .collect(joining());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
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
