package org.toqa.store;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.toqa.persistence.StoreException;

/**
 * Answers that were given before, for the time in which the database does not answer: whoever was
 * logged in goes on to see the robots. It keeps the newest thousand.
 */
final class FallbackCache<K, V> {
  private static final int MAX_ENTRIES = 1000;

  private final Map<K, V> answers =
      Collections.synchronizedMap(
          new LinkedHashMap<>() {
            private static final long serialVersionUID = 1;

            @Override
            protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
              return size() > MAX_ENTRIES;
            }
          });

  /**
   * @param question asks the database
   */
  Optional<V> get(K key, Supplier<Optional<V>> question) {
    try {
      Optional<V> answer = question.get();
      answer.ifPresentOrElse(value -> answers.put(key, value), () -> answers.remove(key));
      return answer;
    } catch (StoreException e) {
      V known = answers.get(key);
      if (known == null) {
        throw e;
      }
      return Optional.of(known);
    }
  }
}
