package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.FloorMap;

/**
 * A task that is to be put in by itself, once or again and again.
 *
 * @param order has no deadline
 * @param until the last moment at which it can be due; null: it has no end
 * @param user in whose name its tasks are put in
 * @param owner the id of his account, for names come back and ids do not; null: he is no user any
 *     more, or the schedule is not stored yet
 * @param resting whether it makes no tasks for now, since its user may not log in or is no user any
 *     more
 * @param due when its next task is put in; null: never again
 * @param lastTask the one that it put in last, if any
 * @param template what its order was made from; null: from no template
 */
public record Schedule(
    long id,
    TaskOrder order,
    Recurrence recurrence,
    @Nullable Instant until,
    boolean paused,
    String user,
    @Nullable Long owner,
    boolean resting,
    Instant createdAt,
    @Nullable Instant due,
    @Nullable Long lastTask,
    @Nullable TemplateUse template) {

  /** One whose order was made from no template. */
  public Schedule(
      long id,
      TaskOrder order,
      Recurrence recurrence,
      @Nullable Instant until,
      boolean paused,
      String user,
      @Nullable Long owner,
      boolean resting,
      Instant createdAt,
      @Nullable Instant due,
      @Nullable Long lastTask) {
    this(
        id, order, recurrence, until, paused, user, owner, resting, createdAt, due, lastTask, null);
  }

  /** One that is not stored yet. */
  public static Schedule of(
      TaskOrder order, Recurrence recurrence, @Nullable Instant until, Orderer by, Instant now) {
    Schedule fresh =
        new Schedule(
            0, order, recurrence, until, false, by.name(), by.account(), false, now, null, null);
    return fresh.withDue(fresh.nextDueAfter(now).orElse(null));
  }

  /**
   * The floor where its tasks are, or would be if there were one of that name.
   *
   * @param floors those that there are, at least one
   */
  public String floor(List<FloorMap> floors) {
    return FloorChoice.among(floors, order.floor(), order.start(), order.goal())
        .map(FloorMap::name)
        .orElseGet(() -> Objects.requireNonNull(order.floor()));
  }

  private Schedule withDue(@Nullable Instant moment) {
    return new Schedule(
        id,
        order,
        recurrence,
        until,
        paused,
        user,
        owner,
        resting,
        createdAt,
        moment,
        lastTask,
        template);
  }

  /** The same, whose order was made from that template. */
  public Schedule from(@Nullable TemplateUse use) {
    return new Schedule(
        id, order, recurrence, until, paused, user, owner, resting, createdAt, due, lastTask, use);
  }

  /** The first moment after that one at which it is due, if there is one. */
  public Optional<Instant> nextDueAfter(Instant moment) {
    return recurrence.nextAfter(moment).filter(next -> until == null || !next.isAfter(until));
  }
}
