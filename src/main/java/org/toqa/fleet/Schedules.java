package org.toqa.fleet;

import java.time.Instant;
import java.util.UUID;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;

/**
 * Changes schedules, one change at a time; {@link ScheduleStore} shows them. What is answered as
 * accepted is stored. Any thread may call it. A stage fails only when the store or the fleet does
 * not answer.
 */
public interface Schedules {

  /**
   * Adds a schedule whose order would be accepted now.
   *
   * @param until the last moment at which it can be due; null: it has no end
   * @param template what the order was made from; null: from no template
   * @param by as of {@link Fleet#submit(TaskOrder, Orderer, UUID)}
   * @param key the same one for the same order, of which one schedule is made
   */
  CompletionStage<KeyedAnswer<Schedule>> add(
      TaskOrder order,
      Recurrence recurrence,
      @Nullable Instant until,
      @Nullable TemplateUse template,
      Orderer by,
      UUID key);

  /** Adds one whose order was made from no template. */
  default CompletionStage<KeyedAnswer<Schedule>> add(
      TaskOrder order, Recurrence recurrence, @Nullable Instant until, String user, UUID key) {
    return add(order, recurrence, until, null, Orderer.named(user), key);
  }

  /** Lets it be due no more until it is resumed. One that is paused stays so. */
  CompletionStage<Answer<Schedule>> pause(long schedule, String user);

  /** Lets it be due again; what was due meanwhile is not made up for. */
  CompletionStage<Answer<Schedule>> resume(long schedule, String user);

  /** Deletes it, and answers what it was. */
  CompletionStage<Answer<Schedule>> delete(long schedule, String user);
}
