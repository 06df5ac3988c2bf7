package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongPredicate;
import org.toqa.allocation.AllocationTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Tasks whose teams had no room, and what becomes of them: where that lay at a robot that cannot go
 * sideways, others are looked for; else the task is tried again after a while. Confined to one
 * agent.
 */
final class RoomFindings {
  /** Then other robots may be free, narrower ones, and the load or its goal elsewhere. */
  private static final Duration RETRY = Duration.ofMinutes(1);

  private final Map<Long, NoRoom> withoutRoom = new HashMap<>();

  /** Why teams had no room with a robot that cannot go sideways. */
  private final Map<Long, Sentence> forOmnidirectional = new HashMap<>();

  /**
   * @param until when the task is tried again
   */
  private record NoRoom(Sentence why, Instant until) {}

  /** A team had no room. */
  void add(long task, PathQuery.TeamQuestion question, Sentence objection, Instant now) {
    if (question.hasDifferential()) {
      forOmnidirectional.put(task, objection);
    } else {
      withoutRoom.put(task, new NoRoom(objection, now.plus(RETRY)));
    }
  }

  /** Whether it is not tried now. */
  boolean isWithoutRoom(long task) {
    return withoutRoom.containsKey(task);
  }

  /** Why it is not tried now. */
  Optional<Sentence> reason(long task) {
    return Optional.ofNullable(withoutRoom.get(task)).map(NoRoom::why);
  }

  /** As it is to be given out. */
  AllocationTask restricted(AllocationTask job) {
    return forOmnidirectional.containsKey(job.id()) ? job.forOmnidirectional() : job;
  }

  /**
   * @param why the allocator says that a task waits
   */
  Sentence explained(long task, Sentence why) {
    Sentence ofOthers = forOmnidirectional.get(task);
    return ofOthers == null ? why : Phrase.WAITS_FOR_OMNIDIRECTIONAL.with(ofOthers);
  }

  /** Those that it is time to try again, with what was said of them; they are forgotten. */
  Map<Long, Sentence> takeDue(Instant now) {
    Map<Long, Sentence> due = new HashMap<>();
    withoutRoom.forEach(
        (task, found) -> {
          if (!now.isBefore(found.until())) {
            due.put(task, found.why());
          }
        });
    withoutRoom.keySet().removeAll(due.keySet());
    return due;
  }

  /** Something else is ordered. */
  void forget(long task) {
    withoutRoom.remove(task);
    forOmnidirectional.remove(task);
  }

  void retain(LongPredicate isQueued) {
    withoutRoom.keySet().removeIf(task -> !isQueued.test(task));
    forOmnidirectional.keySet().removeIf(task -> !isQueued.test(task));
  }
}
