package org.toqa.store;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * A sentence as it is kept in a column: an array of the phrase's name and the values, of which a
 * sentence is such an array too.
 */
final class SentenceJson {
  /** What is longer is kept in English only. */
  static final int MAX_LENGTH = 2000;

  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  private SentenceJson() {}

  /** Null where the English text says all of it. */
  static @Nullable String write(Sentence sentence) {
    String json = sentence.isVerbatim() ? "" : MAPPER.writeValueAsString(array(sentence));
    return json.isEmpty() || json.length() > MAX_LENGTH ? null : json;
  }

  private static List<Object> array(Sentence sentence) {
    List<Object> array = new ArrayList<>();
    array.add(sentence.phrase());
    sentence.values().forEach(v -> array.add(v instanceof Sentence part ? array(part) : v));
    return array;
  }

  /**
   * What was said; where that cannot be read any more, its English text.
   *
   * @param json null: there is the text only
   */
  static Sentence read(@Nullable String json, String text) {
    return Optional.ofNullable(json)
        .flatMap(SentenceJson::sentence)
        .orElseGet(() -> Sentence.verbatim(text));
  }

  private static Optional<Sentence> sentence(String json) {
    try {
      Sentence sentence = sentence(MAPPER.readTree(json));
      return sentence.isComplete() ? Optional.of(sentence) : Optional.empty();
    } catch (JacksonException | IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static Sentence sentence(JsonNode array) {
    List<Object> values = new ArrayList<>();
    for (int i = 1; i < array.size(); i++) {
      values.add(value(array.get(i)));
    }
    return Phrase.valueOf(array.path(0).asString("")).with(values.toArray());
  }

  private static Object value(JsonNode node) {
    if (node.isArray()) {
      return sentence(node);
    }
    return node.isNumber() ? node.numberValue() : node.asString("");
  }
}
