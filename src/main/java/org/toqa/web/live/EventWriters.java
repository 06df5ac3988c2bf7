package org.toqa.web.live;

import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiPredicate;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Site;

/** One writer for all streams that say the same. Any thread may call it. */
final class EventWriters {
  private final Map<Kind, SnapshotEventWriter> writers = new ConcurrentHashMap<>();

  /**
   * Streams that say the same.
   *
   * @param floor the only one that is told of; null: all are
   */
  private record Kind(Site site, Locale locale, @Nullable String floor) {}

  /**
   * The writer of such streams; where it is the first of them, those of what is gone are forgotten.
   *
   * @param floor the only one that is told of; null: all are
   * @param isThere whether there is that site, and that floor of it, if one is named
   */
  SnapshotEventWriter writer(
      Site site,
      Locale locale,
      @Nullable String floor,
      BiPredicate<Site, @Nullable String> isThere) {
    Kind kind = new Kind(site, locale, floor);
    SnapshotEventWriter known = writers.get(kind);
    if (known != null) {
      return known;
    }
    writers.keySet().removeIf(each -> !isThere.test(each.site(), each.floor()));
    return writers.computeIfAbsent(kind, _ -> new SnapshotEventWriter(locale));
  }

  int size() {
    return writers.size();
  }
}
