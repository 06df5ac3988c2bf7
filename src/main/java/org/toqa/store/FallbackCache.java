package org.toqa.store;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.util.Optional;
import java.util.function.Supplier;
import org.toqa.persistence.StoreException;

/**
 * Answers that were given before, for the time in which the database does not answer: whoever was
 * logged in goes on to see the robots. It keeps a thousand.
 */
final class FallbackCache<K, V> {
  private static final int MAX_ENTRIES = 1000;

  private final Cache<K, V> answers = Caffeine.newBuilder().maximumSize(MAX_ENTRIES).build();

  /**
   * @param question asks the database
   */
  Optional<V> get(K key, Supplier<Optional<V>> question) {
    try {
      Optional<V> answer = question.get();
      answer.ifPresentOrElse(value -> answers.put(key, value), () -> answers.invalidate(key));
      return answer;
    } catch (StoreException e) {
      V known = answers.getIfPresent(key);
      if (known == null) {
        throw e;
      }
      return Optional.of(known);
    }
  }
}
