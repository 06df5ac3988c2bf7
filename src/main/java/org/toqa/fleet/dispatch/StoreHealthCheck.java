package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.PeriodicWork;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Asks the store every two seconds, on a thread of its own, whether it is there. When it is back
 * the history gets from when to when it was not.
 */
public final class StoreHealthCheck implements AutoCloseable {
  /** What people are told while it is not. */
  public static final Sentence DATABASE_AWAY = Phrase.DATABASE_AWAY.with();

  private static final Logger log = LoggerFactory.getLogger(StoreHealthCheck.class);
  private static final Duration CHECK_INTERVAL = Duration.ofSeconds(2);

  private final FleetStore store;
  private final Consumer<Boolean> onChange;
  private final InstantSource clock;
  private final PeriodicWork work;
  private volatile boolean isAvailable = true;

  /** Of an outage that the history does not have yet; used by the thread of the watch alone. */
  private @Nullable Instant awaySince;

  /**
   * @param changed is told, on the watch's thread, when the store stops or begins to answer
   */
  public StoreHealthCheck(FleetStore store, InstantSource clock, Consumer<Boolean> changed) {
    this.store = store;
    this.clock = clock;
    this.onChange = changed;
    work = new PeriodicWork("store-watch", CHECK_INTERVAL, this::check);
  }

  /** Whether it did when it was asked last; at first it is taken to. */
  public boolean isAvailable() {
    return isAvailable;
  }

  private void check() {
    boolean now;
    try {
      store.checkAvailable();
      now = true;
    } catch (StoreException e) {
      now = false;
    }
    if (!now && awaySince == null) {
      awaySince = clock.instant();
    } else if (now && awaySince != null) {
      recordOutage(awaySince);
    }
    if (now != isAvailable) {
      isAvailable = now;
      onChange.accept(now);
      log.warn(now ? "The database answers again." : "The database does not answer.");
    }
  }

  /** Where it is away again it is tried once more when it is back. */
  private void recordOutage(Instant since) {
    Instant now = clock.instant();
    try {
      store.addEvents(
          List.of(
              event(since, EventKind.FLEET_DATABASE_AWAY, Phrase.DATABASE_WENT_AWAY.with()),
              event(
                  now,
                  EventKind.FLEET_DATABASE_BACK,
                  Phrase.DATABASE_CAME_BACK.with(Sentence.of(Duration.between(since, now))))));
      awaySince = null;
    } catch (StoreException e) {
      log.warn("The outage of the database is not in the history yet.", e);
    }
  }

  private static EventRecord event(Instant at, EventKind kind, Sentence sentence) {
    return new EventRecord(at, kind, null, null, EventRecord.SYSTEM, sentence);
  }

  @Override
  public void close() {
    work.close();
  }
}
