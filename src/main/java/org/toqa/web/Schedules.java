package org.toqa.web;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer.Refusal;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.web.access.Caller;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What people want of schedules. */
public final class Schedules {
  private static final int MOST = 500;

  private final Services services;
  private final Texts texts;

  public Schedules(Services services, Texts texts) {
    this.services = services;
    this.texts = texts;
  }

  /** A clerk changes his own schedules, a manager all. */
  public static boolean isAllowed(Caller caller, Schedule schedule) {
    return caller.isManager() || caller.name().equalsIgnoreCase(schedule.user());
  }

  /** What became of a wish. */
  public sealed interface Outcome {
    record Answered(Answer<Schedule> answer) implements Outcome {}

    /** It came before, and this is its schedule. */
    record Repeated(Schedule schedule) implements Outcome {}

    /** Its key came before with another wish. */
    record OtherWish() implements Outcome {}
  }

  /**
   * @param key the same one for the same wish
   */
  public Outcome add(
      TaskOrder order, Recurrence recurrence, @Nullable Instant until, Caller user, UUID key) {
    Optional<Schedule> before = services.schedules().scheduleOf(key);
    if (before.isEmpty()) {
      return new Outcome.Answered(addNew(order, recurrence, until, user, key));
    }
    Schedule schedule = before.get();
    return order.equals(schedule.order())
            && recurrence.equals(schedule.recurrence())
            && Objects.equals(until, schedule.until())
        ? new Outcome.Repeated(schedule)
        : new Outcome.OtherWish();
  }

  /**
   * @param key that no schedule has yet
   */
  public Answer<Schedule> addNew(
      TaskOrder order, Recurrence recurrence, @Nullable Instant until, Caller user, UUID key) {
    List<Refusal> refusals =
        FleetAnswers.await(services.fleet().refusals(List.of(order), user.name()));
    if (!refusals.isEmpty()) {
      Refusal refusal = refusals.getFirst();
      return new Answer.Refused<>(refusal.field(), refusal.sentence());
    }
    Schedule schedule =
        Schedule.of(order, recurrence, until, user.name(), services.clock().instant());
    if (schedule.due() == null) {
      return new Answer.Refused<>("until", Sentence.verbatim(texts.get("error.schedule.never")));
    }
    if (services.schedules().schedules().size() >= MOST) {
      return new Answer.Refused<>(null, Sentence.verbatim(texts.get("error.schedule.many", MOST)));
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
              event(schedule, user, "schedule.paused", Phrase.SCHEDULE_PAUSED));
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
              schedule.dueAfter(services.clock().instant()).orElse(null),
              event(schedule, user, "schedule.resumed", Phrase.SCHEDULE_RESUMED));
    }
  }

  public void delete(Schedule schedule, Caller user) {
    services
        .schedules()
        .delete(schedule.id(), event(schedule, user, "schedule.deleted", Phrase.SCHEDULE_DELETED));
  }

  private List<EventRecord> event(Schedule schedule, Caller user, String kind, Phrase done) {
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
