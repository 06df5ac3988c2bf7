package org.toqa.notices;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.PeriodicWork;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.history.EventArchive;
import org.toqa.notices.NoticeStore.Change;
import org.toqa.persistence.StoreException;

/**
 * Watches the fleet for what needs attention, and stores each notice together with all that is to
 * be told of it. What cannot be stored while the database is away waits, and is tried to be told
 * without it.
 */
public final class NoticeRecorder implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(NoticeRecorder.class);
  private static final Duration PERIOD = Duration.ofSeconds(1);

  /** So old are receivers at most that are told while the database is away. */
  private static final Duration PLAN_AGE = Duration.ofSeconds(30);

  /** What waits for the database; while it is as much, nothing more is looked for. */
  private static final int MOST_WAITING = 1000;

  private final SnapshotFeed fleet;
  private final EventConditions events;
  private final Notices notices;
  private final Outbox outbox;
  private final InstantSource clock;
  private final PeriodicWork work;

  // Of the periodic work's thread from here on

  /** Null until the store has told what was open before. */
  private @Nullable NoticeTracker tracker;

  private DeliveryPlan plan = DeliveryPlan.NOBODY;
  private Instant planAt = Instant.EPOCH;
  private final List<Change> waiting = new ArrayList<>();

  public NoticeRecorder(
      SnapshotFeed fleet,
      EventArchive history,
      Notices notices,
      Outbox outbox,
      InstantSource clock) {
    this(fleet, history, notices, outbox, clock, PERIOD);
  }

  /**
   * @param period between two looks
   */
  NoticeRecorder(
      SnapshotFeed fleet,
      EventArchive history,
      Notices notices,
      Outbox outbox,
      InstantSource clock,
      Duration period) {
    this.fleet = fleet;
    this.events = new EventConditions(history);
    this.notices = notices;
    this.outbox = outbox;
    this.clock = clock;
    this.work = new PeriodicWork("notices", period, this::look);
  }

  private void look() {
    Instant now = clock.instant();
    if (tracker == null) {
      tracker = openBefore(now);
    }
    NoticeTracker before = tracker;
    if (before == null) {
      return;
    }
    if (waiting.size() >= MOST_WAITING) {
      store(now);
      return;
    }
    NoticeTracker.Step step = before.next(conditions(now), now);
    tracker = step.tracker();
    if (!step.isEmpty() || now.isBefore(planAt) || !now.isBefore(planAt.plus(PLAN_AGE))) {
      renewPlan(now);
    }
    List<Change> found = new ArrayList<>();
    step.begun().forEach(notice -> found.add(plan.change(notice, false, now)));
    step.ended().forEach(notice -> found.add(plan.change(notice, true, now)));
    waiting.addAll(found);
    if (!waiting.isEmpty() && !store(now)) {
      found.forEach(change -> outbox.tellDirectly(change, plan));
    }
  }

  private List<Condition> conditions(Instant now) {
    List<Condition> all = new ArrayList<>(Conditions.of(fleet.latest()));
    all.addAll(events.at(now));
    return all;
  }

  /** Null: the store does not answer. */
  private @Nullable NoticeTracker openBefore(Instant now) {
    try {
      return NoticeTracker.of(notices.store().open(), now);
    } catch (StoreException e) {
      return null;
    }
  }

  /** While the store does not answer it stays as it was. */
  private void renewPlan(Instant now) {
    planAt = now;
    try {
      plan = new DeliveryPlan(notices.store().people(), notices.store().webhooks());
    } catch (StoreException e) {
      log.debug("Who is to be told is as it was.", e);
    }
  }

  /** Whether all that waits is stored now. */
  private boolean store(Instant now) {
    try {
      notices.add(waiting, now, outbox::isToldDirectly);
      outbox.forgetToldDirectly(waiting);
      waiting.clear();
      return true;
    } catch (StoreException e) {
      log.warn("Notices could not be stored; they wait: {}", e.getMessage());
      return false;
    }
  }

  @Override
  public void close() {
    work.close();
  }
}
