package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.PeriodicWork;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Asks the store every two seconds, on a thread of its own, whether it is there. */
public final class StoreHealthCheck implements AutoCloseable {
  /** What people are told while it is not. */
  public static final Sentence DATABASE_AWAY = Phrase.DATABASE_AWAY.with();

  private static final Logger log = LoggerFactory.getLogger(StoreHealthCheck.class);
  private static final Duration CHECK_INTERVAL = Duration.ofSeconds(2);

  private final FleetStore store;
  private final Consumer<Boolean> onChange;
  private final PeriodicWork work;
  private volatile boolean isAvailable = true;

  /**
   * @param changed is told, on the watch's thread, when the store stops or begins to answer
   */
  public StoreHealthCheck(FleetStore store, Consumer<Boolean> changed) {
    this.store = store;
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
    if (now != isAvailable) {
      isAvailable = now;
      onChange.accept(now);
      log.warn(now ? "The database answers again." : "The database does not answer.");
    }
  }

  @Override
  public void close() {
    work.close();
  }
}
