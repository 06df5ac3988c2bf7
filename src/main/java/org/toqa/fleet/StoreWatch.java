package org.toqa.fleet;

import java.time.Duration;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetStore.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Asks the store every two seconds, on a thread of its own, whether it is there. */
final class StoreWatch implements AutoCloseable {
  /** What people are told while it is not. */
  static final Sentence AWAY = Phrase.DATABASE_AWAY.with();

  private static final Logger log = LoggerFactory.getLogger(StoreWatch.class);
  private static final Duration PACE = Duration.ofSeconds(2);

  private final FleetStore store;
  private final Consumer<Boolean> changed;
  private final PacedWork work;
  private volatile boolean answers = true;

  /**
   * @param changed is told, on the watch's thread, when the store stops or begins to answer
   */
  StoreWatch(FleetStore store, Consumer<Boolean> changed) {
    this.store = store;
    this.changed = changed;
    work = new PacedWork("store-watch", PACE, this::look);
  }

  /** Whether it did when it was asked last; at first it is taken to. */
  boolean answers() {
    return answers;
  }

  private void look() {
    boolean now;
    try {
      store.check();
      now = true;
    } catch (StoreException e) {
      now = false;
    }
    if (now != answers) {
      answers = now;
      changed.accept(now);
      log.warn(now ? "The database answers again." : "The database does not answer.");
    }
  }

  @Override
  public void close() {
    work.close();
  }
}
