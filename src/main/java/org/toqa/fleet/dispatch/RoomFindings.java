package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongPredicate;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.AllocationTask;
import org.toqa.allocation.Candidate;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Tasks whose teams had no room, and what becomes of them: where other teams may have it, narrower
 * ones or those that can go sideways, they are looked for; else the task is not tried. After a
 * while nothing of that counts any more. Confined to one agent.
 */
final class RoomFindings {
  /** Then other robots may be free, and the load or its goal elsewhere. */
  private static final Duration RETRY = Duration.ofMinutes(1);

  private final Map<Long, NoRoom> findings = new HashMap<>();

  /**
   * @param limits of teams that may have room
   * @param isForOthers whether there are robots for such a team
   * @param until when whatever team is tried again
   */
  private record NoRoom(Sentence why, RoomLimits limits, boolean isForOthers, Instant until) {}

  /**
   * A team had no room.
   *
   * @param job for the robots that were chosen
   * @param robots of the floor, whatever they do
   */
  void add(
      AllocationTask job,
      PathQuery.TeamQuestion question,
      Sentence objection,
      List<Candidate> robots,
      Instant now) {
    NoRoom before = findings.get(job.id());
    RoomLimits limits = (before == null ? RoomLimits.NONE : before.limits()).without(question);
    boolean isForOthers = limits.restrict(job, robots).isPresent();
    findings.put(job.id(), new NoRoom(objection, limits, isForOthers, now.plus(RETRY)));
  }

  /** Whether it is not tried now. */
  boolean isWithoutRoom(long task) {
    return reason(task).isPresent();
  }

  /** Why it is not tried now. */
  Optional<Sentence> reason(long task) {
    return Optional.ofNullable(findings.get(task))
        .filter(found -> !found.isForOthers())
        .map(NoRoom::why);
  }

  private @Nullable NoRoom ofOthers(long task) {
    NoRoom found = findings.get(task);
    return found != null && found.isForOthers() ? found : null;
  }

  /**
   * As it is to be given out.
   *
   * @param job for the robots that were chosen
   */
  AllocationTask restricted(AllocationTask job, List<Candidate> robots) {
    NoRoom found = ofOthers(job.id());
    return found == null ? job : found.limits().restrict(job, robots).orElse(job);
  }

  /**
   * @param why the allocator says that a task waits
   */
  Sentence explained(long task, Sentence why) {
    NoRoom found = ofOthers(task);
    return found == null ? why : Phrase.WAITS_FOR_OTHER_ROBOTS.with(found.why());
  }

  /** Those that it is time to try again, with what was said of them; they are forgotten. */
  Map<Long, Sentence> takeDue(Instant now) {
    Map<Long, Sentence> due = new HashMap<>();
    findings.forEach(
        (task, found) -> {
          if (!now.isBefore(found.until())) {
            due.put(task, explained(task, found.why()));
          }
        });
    findings.keySet().removeAll(due.keySet());
    return due;
  }

  /** Something else is ordered. */
  void forget(long task) {
    findings.remove(task);
  }

  void retain(LongPredicate isQueued) {
    findings.keySet().removeIf(task -> !isQueued.test(task));
  }
}
