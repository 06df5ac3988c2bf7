package org.toqa.fleet.schedule;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.Schedules;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TemplateUse;
import org.toqa.wording.Phrase;

/**
 * The schedules in a store. One server writes to a database, so changes that come at once are kept
 * apart by a lock here: what one reads is still so when it writes. A new one is stored while its
 * floor stays as it was when it was asked about the order: maps are checked against what is stored.
 */
public final class StoredSchedules implements Schedules {
  private static final int MAX_SCHEDULES = 500;

  private final ScheduleStore store;
  private final Fleet fleet;
  private final InstantSource clock;
  private final Lock changes = new ReentrantLock();

  /**
   * @param fleet checks the orders
   * @param clock for the times in the history and of what is due
   */
  public StoredSchedules(ScheduleStore store, Fleet fleet, InstantSource clock) {
    this.store = store;
    this.fleet = fleet;
    this.clock = clock;
  }

  @Override
  public CompletionStage<KeyedAnswer<Schedule>> add(
      TaskOrder order,
      Recurrence recurrence,
      @Nullable Instant until,
      @Nullable TemplateUse template,
      Orderer by,
      UUID key) {
    Asked asked = new Asked(order, recurrence, until, template, by, key);
    return inBackground(() -> answerFromBefore(asked).orElseGet(() -> addNew(asked)));
  }

  private record Asked(
      TaskOrder order,
      Recurrence recurrence,
      @Nullable Instant until,
      @Nullable TemplateUse template,
      Orderer by,
      UUID key) {}

  private Optional<KeyedAnswer<Schedule>> answerFromBefore(Asked asked) {
    return store
        .scheduleByKey(asked.key())
        .map(
            before ->
                asked.order().equals(before.order())
                        && asked.recurrence().equals(before.recurrence())
                        && Objects.equals(asked.until(), before.until())
                    ? new KeyedAnswer.Repeated<>(before)
                    : new KeyedAnswer.KeyReused<>());
  }

  private KeyedAnswer<Schedule> addNew(Asked asked) {
    return fleet
        .decide(
            asked.order(),
            asked.by().name(),
            rejection ->
                rejection
                    .<KeyedAnswer<Schedule>>map(
                        why ->
                            new KeyedAnswer.Answered<>(
                                new Answer.Rejected<>(why.field(), why.sentence())))
                    .orElseGet(() -> storeNew(asked)))
        .toCompletableFuture()
        .join();
  }

  private KeyedAnswer<Schedule> storeNew(Asked asked) {
    return whileLocked(
        () -> answerFromBefore(asked).orElseGet(() -> new KeyedAnswer.Answered<>(store(asked))));
  }

  private Answer<Schedule> store(Asked asked) {
    Schedule schedule =
        Schedule.of(asked.order(), asked.recurrence(), asked.until(), asked.by(), clock.instant())
            .from(asked.template());
    if (schedule.due() == null) {
      return new Answer.Rejected<>("until", Phrase.SCHEDULE_NEVER_DUE.with());
    }
    if (store.schedules().size() >= MAX_SCHEDULES) {
      return new Answer.Rejected<>(null, Phrase.TOO_MANY_SCHEDULES.with(MAX_SCHEDULES));
    }
    OptionalLong id = store.add(schedule, asked.key());
    return id.isPresent()
        ? new Answer.Accepted<>(store.schedule(id.getAsLong()).orElseThrow())
        : new Answer.Rejected<>(null, Phrase.TEMPLATE_CHANGED.with());
  }

  @Override
  public CompletionStage<Answer<Schedule>> pause(long schedule, String user) {
    return change(
        schedule,
        before -> {
          if (!before.paused()) {
            store.savePause(
                schedule,
                true,
                before.due(),
                events(before, user, EventKind.SCHEDULE_PAUSED, Phrase.SCHEDULE_PAUSED));
          }
          return store.schedule(schedule).orElseThrow();
        });
  }

  @Override
  public CompletionStage<Answer<Schedule>> resume(long schedule, String user) {
    return change(
        schedule,
        before -> {
          if (before.paused()) {
            store.savePause(
                schedule,
                false,
                before.nextDueAfter(clock.instant()).orElse(null),
                events(before, user, EventKind.SCHEDULE_RESUMED, Phrase.SCHEDULE_RESUMED));
          }
          return store.schedule(schedule).orElseThrow();
        });
  }

  @Override
  public CompletionStage<Answer<Schedule>> delete(long schedule, String user) {
    return change(
        schedule,
        before -> {
          store.delete(
              schedule, events(before, user, EventKind.SCHEDULE_DELETED, Phrase.SCHEDULE_DELETED));
          return before;
        });
  }

  private List<EventRecord> events(Schedule schedule, String user, EventKind kind, Phrase done) {
    return List.of(
        new EventRecord(
            clock.instant(),
            kind,
            null,
            null,
            user,
            done.with(user, schedule.id(), schedule.order().name())));
  }

  /**
   * @param change gets the schedule as it is, and answers what it has become
   */
  private CompletionStage<Answer<Schedule>> change(
      long schedule, Function<Schedule, Schedule> change) {
    return inBackground(
        () ->
            whileLocked(
                () -> {
                  Optional<Schedule> before = store.schedule(schedule);
                  if (before.isEmpty()) {
                    return new Answer.Unknown<>(Phrase.NO_SUCH_SCHEDULE.with(schedule));
                  }
                  return new Answer.Accepted<>(change.apply(before.get()));
                }));
  }

  private <T> T whileLocked(Supplier<T> work) {
    changes.lock();
    try {
      return work.get();
    } finally {
      changes.unlock();
    }
  }

  private static <T> CompletionStage<T> inBackground(Supplier<T> work) {
    return CompletableFuture.supplyAsync(
        work, task -> Thread.ofVirtual().name("schedules").start(task));
  }
}
