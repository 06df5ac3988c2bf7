package org.toqa.web.input;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/** What is wrong with the fields of a form or a document: one sentence a field, in order. */
public final class FieldErrors {
  private final Map<String, String> sentences = new LinkedHashMap<>();

  /** The first sentence for a field stays. */
  public void add(String field, String sentence) {
    sentences.putIfAbsent(field, sentence);
  }

  public boolean isEmpty() {
    return sentences.isEmpty();
  }

  /** Sentences by field. */
  public Map<String, String> sentences() {
    return Collections.unmodifiableMap(sentences);
  }
}
