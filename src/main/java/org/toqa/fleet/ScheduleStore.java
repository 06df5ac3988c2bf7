package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.UUID;
import org.jspecify.annotations.Nullable;

/**
 * Keeps schedules. Each call is one transaction; it throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer. Called by threads that may
 * wait.
 */
public interface ScheduleStore {

  /** In the order in which they came. */
  List<Schedule> schedules();

  Optional<Schedule> schedule(long id);

  /** The one that came with that key. */
  Optional<Schedule> scheduleByKey(UUID key);

  /** Those that are not paused and due by then, also those that rest. */
  List<Schedule> due(Instant now);

  /**
   * @param key idempotency key: what comes again with it is stored once
   * @return its id; empty: the template of its order is another one by now, or gone
   */
  OptionalLong add(Schedule schedule, UUID key);

  /**
   * What was due is done.
   *
   * @param schedule as it was
   * @param next when it is due again; null: never
   */
  void advance(
      Schedule schedule, @Nullable Instant next, @Nullable Long lastTask, List<EventRecord> events);

  /**
   * @param due when its next task is put in
   */
  void savePause(long id, boolean paused, @Nullable Instant due, List<EventRecord> events);

  void delete(long id, List<EventRecord> events);
}
