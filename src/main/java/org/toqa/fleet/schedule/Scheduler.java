package org.toqa.fleet.schedule;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TaskView;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Puts in the tasks of schedules when they are due: one task for one due time, also where the
 * server ends between the task and the note that it is there, since the due time is the task's key.
 *
 * <ul>
 *   <li>While the last task of a schedule has not ended, what is due is skipped.
 *   <li>While its user is disabled, or none any more, what is due is skipped too.
 *   <li>Of what was due while no server ran, or which a clock that jumped forward passed over, one
 *       task is made up for, and it is told how many others there were.
 *   <li>When the clock is set back, the next due time is the next one by the clock.
 * </ul>
 */
public final class Scheduler {
  private static final Logger log = LoggerFactory.getLogger(Scheduler.class);
  private static final Duration LIMIT = Duration.ofSeconds(12);

  /** A clock that is set back by less was put right. */
  private static final Duration CLOCK_JITTER = Duration.ofMinutes(1);

  private static final int MAX_MISSED = 10_000;

  private final ScheduleStore store;
  private final TaskArchive archive;
  private final Fleet fleet;
  private final InstantSource clock;
  private @Nullable Instant lastLook;

  public Scheduler(ScheduleStore store, TaskArchive archive, Fleet fleet, InstantSource clock) {
    this.store = store;
    this.archive = archive;
    this.fleet = fleet;
    this.clock = clock;
  }

  /** Does what is due now. To be called about every second, by one thread. */
  public void runDueSchedules() {
    Instant now = clock.instant();
    try {
      if (lastLook == null || now.isBefore(lastLook.minus(CLOCK_JITTER))) {
        bringForward(now);
      }
      lastLook = now;
      for (Schedule schedule : store.due(now)) {
        run(schedule, now);
      }
    } catch (StoreException e) { // of which people are told elsewhere, once
      log.debug("The schedules wait for the database: {}", e.getMessage());
    }
  }

  /**
   * What a clock that was ahead has put off, maybe beyond its end, is due again when it is due by
   * the clock now.
   */
  private void bringForward(Instant now) {
    for (Schedule schedule : store.schedules()) {
      Instant next = schedule.nextDueAfter(now).orElse(null);
      if (!schedule.paused() && next != null && isLater(schedule, next)) {
        log.warn("{} is due again at {}, since the clock was set back.", name(schedule), next);
        store.savePause(schedule.id(), false, next, List.of());
      }
    }
  }

  /** Whether its task is put in later than then, or never; one that is due once had its own. */
  private static boolean isLater(Schedule schedule, Instant next) {
    Instant due = schedule.due();
    return due == null ? !(schedule.recurrence() instanceof Recurrence.Once) : next.isBefore(due);
  }

  private void run(Schedule schedule, Instant now) {
    UUID key = key(schedule);
    if (fleet.isSubmissionPending(key)) {
      return; // whether its task is there is known later
    }
    Optional<TaskView> before = archive.taskByKey(key);
    Optional<TaskView> open = lastTask(schedule).filter(task -> !task.state().isEnded());
    if (before.isPresent()) {
      began(schedule, before.get().id(), now);
    } else if (schedule.resting()) {
      advance(
          schedule,
          now,
          EventKind.SCHEDULE_SKIPPED,
          null,
          Phrase.SCHEDULE_RESTED.with(schedule.id(), schedule.user()));
    } else if (open.isPresent()) {
      long task = open.get().id();
      advance(
          schedule,
          now,
          EventKind.SCHEDULE_SKIPPED,
          task,
          Phrase.SCHEDULE_SKIPPED.with(schedule.id(), schedule.user(), task));
    } else {
      begin(schedule, key, now);
    }
  }

  private Optional<TaskView> lastTask(Schedule schedule) {
    return Optional.ofNullable(schedule.lastTask()).flatMap(archive::task);
  }

  private void begin(Schedule schedule, UUID key, Instant now) {
    try {
      switch (fleet
          .submit(schedule.order(), new Orderer(schedule.user(), schedule.owner()), key)
          .toCompletableFuture()
          .get(LIMIT.toMillis(), TimeUnit.MILLISECONDS)) {
        case Answer.Accepted<TaskView>(TaskView task) -> began(schedule, task.id(), now);
        case Answer.Rejected<TaskView>(String field, Sentence sentence) ->
            refused(schedule, sentence, now);
        case Answer.Conflict<TaskView>(Sentence sentence, var needs) ->
            refused(schedule, sentence, now);
        case Answer.Outdated<TaskView>() ->
            throw new IllegalStateException("A new task is not outdated.");
        case Answer.Unknown<TaskView>(Sentence sentence) -> refused(schedule, sentence, now);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException | TimeoutException e) {
      log.warn(
          "{} is tried again, since the fleet did not answer: {}", name(schedule), e.toString());
    }
  }

  private void began(Schedule schedule, long task, Instant now) {
    advance(
        schedule,
        now,
        EventKind.SCHEDULE_BEGAN,
        task,
        Phrase.SCHEDULE_BEGAN.with(schedule.id(), schedule.user()));
  }

  private void refused(Schedule schedule, Sentence sentence, Instant now) {
    advance(
        schedule,
        now,
        EventKind.SCHEDULE_REFUSED,
        null,
        Phrase.SCHEDULE_REFUSED.with(schedule.id(), schedule.user(), sentence));
  }

  private void advance(
      Schedule schedule, Instant now, EventKind kind, @Nullable Long task, Sentence text) {
    List<EventRecord> events = new ArrayList<>();
    events.add(new EventRecord(now, kind, task, null, EventRecord.SYSTEM, text));
    long missed = missedTimes(schedule, now);
    if (missed > 0) {
      Sentence told = Phrase.SCHEDULE_MISSED.with(schedule.id(), schedule.user(), missed);
      events.add(
          new EventRecord(now, EventKind.SCHEDULE_SKIPPED, task, null, EventRecord.SYSTEM, told));
    }
    store.advance(
        schedule,
        schedule.nextDueAfter(now).orElse(null),
        task == null ? schedule.lastTask() : task,
        events);
  }

  /** How often it was due between its due time and now, both left out; it counts so far only. */
  private static long missedTimes(Schedule schedule, Instant now) {
    return schedule.due() == null
        ? 0
        : Stream.iterate(
                schedule.nextDueAfter(schedule.due()),
                next -> next.filter(at -> !at.isAfter(now)).isPresent(),
                next -> next.flatMap(schedule::nextDueAfter))
            .limit(MAX_MISSED)
            .count();
  }

  private static String name(Schedule schedule) {
    return "Schedule %d of %s".formatted(schedule.id(), schedule.user());
  }

  private static UUID key(Schedule schedule) {
    return UUID.nameUUIDFromBytes(
        "schedule %d %s".formatted(schedule.id(), schedule.due()).getBytes(StandardCharsets.UTF_8));
  }
}
