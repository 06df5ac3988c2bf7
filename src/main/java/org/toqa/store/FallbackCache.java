package org.toqa.store;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.toqa.persistence.StoreException;

/**
 * Answers that were given before, for the time in which the database does not answer: a thousand.
 */
final class FallbackCache<K, V> {
  private static final int MAX_ENTRIES = 1000;

  private final Cache<K, V> answers = Caffeine.newBuilder().maximumSize(MAX_ENTRIES).build();

  /** How often something was forgotten: what was asked before it is not kept after it. */
  private final AtomicLong changes = new AtomicLong();

  /**
   * @param question asks the database
   */
  Optional<V> get(K key, Supplier<Optional<V>> question) {
    long before = changes.get();
    try {
      Optional<V> answer = question.get();
      answer.ifPresentOrElse(value -> put(key, value, before), () -> answers.invalidate(key));
      return answer;
    } catch (StoreException e) {
      V known = answers.getIfPresent(key);
      if (known == null) {
        throw e;
      }
      return Optional.of(known);
    }
  }

  private void put(K key, V value, long before) {
    answers.put(key, value);
    if (changes.get() != before) {
      answers.invalidate(key);
    }
  }

  void forget(K key) {
    changes.incrementAndGet();
    answers.invalidate(key);
  }

  void forgetAll(Predicate<V> isOutdated) {
    changes.incrementAndGet();
    answers.asMap().values().removeIf(isOutdated);
  }
}
