package org.toqa.notices;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.history.EventArchive;
import org.toqa.fleet.history.EventArchive.Entry;
import org.toqa.fleet.history.EventArchive.Filter;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Sentence;

/**
 * Single events that need attention, read from the history, where none is lost by a crash. Each
 * counts as a condition for an hour; the same one again within that time is the same condition.
 */
final class EventConditions {
  private static final Duration LIFE = Duration.ofHours(1);

  /** Between two looks at the history. */
  private static final Duration PERIOD = Duration.ofSeconds(5);

  private static final int MOST = 100;

  private final EventArchive history;
  private Instant lookedAt = Instant.EPOCH;
  private List<Condition> found = List.of();

  EventConditions(EventArchive history) {
    this.history = history;
  }

  /** Those of the last hour; while the store does not answer, those that were found last. */
  List<Condition> at(Instant now) {
    if (now.isBefore(lookedAt) || !now.isBefore(lookedAt.plus(PERIOD))) {
      lookedAt = now;
      try {
        found =
            history.events(refusedSince(now.minus(LIFE)), Long.MAX_VALUE, MOST).stream()
                .map(Entry::event)
                .map(EventConditions::condition)
                .toList();
      } catch (StoreException e) {
        return found; // which is told elsewhere
      }
    }
    return found;
  }

  private static Filter refusedSince(Instant from) {
    String kind = EventKind.SCHEDULE_REFUSED.text();
    return new Filter(null, null, null, kind, from, null, false);
  }

  private static Condition condition(EventRecord event) {
    return new Condition(
        NoticeKind.SCHEDULE_REFUSED,
        schedule(event.sentence()),
        event.floor(),
        event.task(),
        event.robot(),
        null,
        event.sentence());
  }

  /** Its number is the first that is said of it; what cannot be read stands for itself. */
  private static String schedule(Sentence said) {
    @Nullable Object first =
        said.isVerbatim() || said.values().isEmpty() ? null : said.values().getFirst();
    return first == null ? said.english() : first.toString();
  }
}
