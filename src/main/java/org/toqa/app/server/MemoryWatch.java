package org.toqa.app.server;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Tells when so much of the heap stays in use after a garbage collection that little is left. */
final class MemoryWatch {
  private static final double EXHAUSTED = 0.97;
  private static final int MEGABYTE = 1024 * 1024;

  private final Supplier<@Nullable MemoryUsage> afterCollection;

  /**
   * @param afterCollection null before the first one
   */
  MemoryWatch(Supplier<@Nullable MemoryUsage> afterCollection) {
    this.afterCollection = afterCollection;
  }

  /** Of the largest pool of this process's heap, which is that of old objects. */
  static MemoryWatch ofThisProcess() {
    return ManagementFactory.getMemoryPoolMXBeans().stream()
        .filter(pool -> pool.getType() == MemoryType.HEAP)
        .filter(pool -> pool.getCollectionUsage() != null)
        .max(Comparator.comparingLong(pool -> pool.getUsage().getMax()))
        .map(MemoryPoolMXBean.class::cast)
        .map(pool -> new MemoryWatch(pool::getCollectionUsage))
        .orElseGet(() -> new MemoryWatch(() -> null));
  }

  /** The sentence, while the memory is exhausted. */
  Optional<Sentence> check() {
    return Optional.ofNullable(afterCollection.get())
        .filter(usage -> usage.getMax() > 0)
        .filter(usage -> usage.getUsed() > EXHAUSTED * usage.getMax())
        .map(
            usage ->
                Phrase.MEMORY_EXHAUSTED.with(
                    usage.getUsed() / MEGABYTE, usage.getMax() / MEGABYTE));
  }
}
