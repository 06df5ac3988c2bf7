package org.toqa.web.input;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer.Rejection;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.schedule.Recurrence;
import org.toqa.fleet.schedule.Schedule;
import org.toqa.web.FleetAnswers;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What people want of schedules. */
public final class ScheduleCommands {
  private static final int MAX_SCHEDULES = 500;

  private final Services services;
  private final Texts texts;

  public ScheduleCommands(Services services, Texts texts) {
    this.services = services;
    this.texts = texts;
  }

  /** A clerk changes his own schedules, a manager all. */
  public static boolean canChange(Caller caller, Schedule schedule) {
    return caller.isManager() || caller.name().equalsIgnoreCase(schedule.user());
  }

  /** What became of a wish. */
  public sealed interface Outcome {
    record Answered(Answer<Schedule> answer) implements Outcome {}

    /** It came before, and this is its schedule. */
    record Repeated(Schedule schedule) implements Outcome {}

    /** Its key came before with another wish. */
    record KeyReused() implements Outcome {}
  }

  /**
   * @param key the same one for the same wish
   */
  public Outcome add(
      TaskOrder order, Recurrence recurrence, @Nullable Instant until, Caller user, UUID key) {
    Optional<Schedule> before = services.schedules().scheduleByKey(key);
    if (before.isEmpty()) {
      return new Outcome.Answered(create(order, recurrence, until, user, key));
    }
    Schedule schedule = before.get();
    return order.equals(schedule.order())
            && recurrence.equals(schedule.recurrence())
            && Objects.equals(until, schedule.until())
        ? new Outcome.Repeated(schedule)
        : new Outcome.KeyReused();
  }

  /**
   * @param key that no schedule has yet
   */
  public Answer<Schedule> create(
      TaskOrder order, Recurrence recurrence, @Nullable Instant until, Caller user, UUID key) {
    List<Rejection> refusals =
        FleetAnswers.await(services.fleet().rejections(List.of(order), user.name()));
    if (!refusals.isEmpty()) {
      Rejection refusal = refusals.getFirst();
      return new Answer.Rejected<>(refusal.field(), refusal.sentence());
    }
    Schedule schedule =
        Schedule.of(order, recurrence, until, user.name(), services.clock().instant());
    if (schedule.due() == null) {
      return new Answer.Rejected<>("until", Sentence.verbatim(texts.get("error.schedule.never")));
    }
    if (services.schedules().schedules().size() >= MAX_SCHEDULES) {
      return new Answer.Rejected<>(
          null, Sentence.verbatim(texts.get("error.schedule.many", MAX_SCHEDULES)));
    }
    long id = services.schedules().add(schedule, key);
    return new Answer.Accepted<>(services.schedules().schedule(id).orElseThrow());
  }

  public void pause(Schedule schedule, Caller user) {
    if (!schedule.paused()) {
      services
          .schedules()
          .savePause(
              schedule.id(),
              true,
              schedule.due(),
              events(schedule, user, EventKind.SCHEDULE_PAUSED, Phrase.SCHEDULE_PAUSED));
    }
  }

  /** What was due meanwhile is not made up for. */
  public void resume(Schedule schedule, Caller user) {
    if (schedule.paused()) {
      services
          .schedules()
          .savePause(
              schedule.id(),
              false,
              schedule.nextDueAfter(services.clock().instant()).orElse(null),
              events(schedule, user, EventKind.SCHEDULE_RESUMED, Phrase.SCHEDULE_RESUMED));
    }
  }

  public void delete(Schedule schedule, Caller user) {
    services
        .schedules()
        .delete(
            schedule.id(),
            events(schedule, user, EventKind.SCHEDULE_DELETED, Phrase.SCHEDULE_DELETED));
  }

  private List<EventRecord> events(Schedule schedule, Caller user, EventKind kind, Phrase done) {
    return List.of(
        new EventRecord(
            services.clock().instant(),
            kind,
            null,
            null,
            user.name(),
            done.with(user.name(), schedule.id(), schedule.order().name())));
  }
}
