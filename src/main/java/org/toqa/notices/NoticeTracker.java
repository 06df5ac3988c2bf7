package org.toqa.notices;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.notices.Condition.Key;

/**
 * Makes of conditions, looked at again and again, notices: one when a condition has lasted for the
 * patience of its kind, and its end when it has been over for as long. One that comes and goes
 * faster is one notice.
 *
 * @param tracked each condition that there is, or was a moment ago
 * @param endsFrom nothing ends before: after a start the fleet is not heard at once
 */
record NoticeTracker(Map<Key, Tracked> tracked, Instant endsFrom) {

  /** For how long after a start nothing is said to have ended. */
  static final Duration SETTLING = Duration.ofSeconds(60);

  NoticeTracker {
    tracked = Map.copyOf(tracked);
  }

  /**
   * @param notice null: it has not lasted long enough
   * @param since when it was there first
   * @param last when it was there last
   */
  record Tracked(@Nullable Notice notice, Instant since, Instant last) {}

  /**
   * @param begun new notices, not stored yet
   * @param ended notices whose conditions are over
   */
  record Step(NoticeTracker tracker, List<Notice> begun, List<Notice> ended) {
    boolean isEmpty() {
      return begun.isEmpty() && ended.isEmpty();
    }
  }

  /**
   * @param open notices whose conditions lasted when they were looked at last
   */
  static NoticeTracker of(List<Notice> open, Instant now) {
    Map<Key, Tracked> tracked = new HashMap<>();
    for (Notice notice : open) {
      tracked.put(notice.condition().key(), new Tracked(notice, notice.begunAt(), now));
    }
    return new NoticeTracker(tracked, now.plus(SETTLING));
  }

  /** Where the clock was set back meanwhile, nothing waits longer than from now on. */
  private NoticeTracker asOf(Instant now) {
    Map<Key, Tracked> earlier = new HashMap<>();
    tracked.forEach(
        (key, one) ->
            earlier.put(
                key,
                new Tracked(one.notice(), earlier(one.since(), now), earlier(one.last(), now))));
    return new NoticeTracker(earlier, earlier(endsFrom, now.plus(SETTLING)));
  }

  private static Instant earlier(Instant one, Instant other) {
    return one.isBefore(other) ? one : other;
  }

  /** What has begun and ended since. */
  Step next(List<Condition> conditions, Instant now) {
    return asOf(now).following(conditions, now);
  }

  private Step following(List<Condition> conditions, Instant now) {
    Map<Key, Tracked> next = new HashMap<>();
    List<Notice> begun = new ArrayList<>();
    for (Condition condition : conditions) {
      if (next.containsKey(condition.key())) {
        continue;
      }
      Tracked before = tracked.get(condition.key());
      Instant since = before == null ? now : before.since();
      Notice notice = before == null ? null : before.notice();
      if (notice == null && !since.plus(condition.kind().patience()).isAfter(now)) {
        notice = new Notice(0, UUID.randomUUID(), condition, since, null);
        begun.add(notice);
      }
      next.put(condition.key(), new Tracked(notice, since, now));
    }
    List<Notice> ended = new ArrayList<>();
    tracked.forEach(
        (key, before) -> {
          if (next.containsKey(key)) {
            return;
          }
          Notice notice = before.notice();
          boolean isOver = !before.last().plus(key.kind().patience()).isAfter(now);
          if (notice != null && isOver && !now.isBefore(endsFrom)) {
            ended.add(notice.ended(before.last()));
          } else if (notice != null || !isOver) {
            next.put(key, before);
          }
        });
    return new Step(new NoticeTracker(next, endsFrom), List.copyOf(begun), List.copyOf(ended));
  }
}
