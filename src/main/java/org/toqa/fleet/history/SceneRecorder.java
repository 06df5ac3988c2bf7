package org.toqa.fleet.history;

import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.PeriodicWork;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.persistence.StoreException;

/**
 * Writes down where loads were and which paths robots had ahead, for replays, on a thread of its
 * own. A killed server loses the last ten seconds of it; what changes while the store does not
 * answer waits, up to a limit.
 */
public final class SceneRecorder implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(SceneRecorder.class);
  private static final Duration OBSERVE_INTERVAL = Duration.ofSeconds(1);
  private static final Duration WRITE_INTERVAL = Duration.ofSeconds(10);
  private static final int MOST_WAITING = 20_000;

  private final SnapshotFeed feed;
  private final SceneStore store;
  private final PeriodicWork work;
  private @Nullable SceneObserver observer; // null until the store has said what was before
  private long observed = -1;
  private long written = System.nanoTime();

  public SceneRecorder(SnapshotFeed feed, SceneStore store) {
    this.feed = feed;
    this.store = store;
    work = new PeriodicWork("scenes", OBSERVE_INTERVAL, this::observe);
  }

  private void observe() {
    try {
      if (observer == null) {
        observer = new SceneObserver(store.openLoads(), store.openPaths());
      }
      FleetSnapshot latest = feed.latest();
      if (latest.version() != observed) {
        observed = latest.version();
        observer.observe(latest);
      }
      if (System.nanoTime() - written > WRITE_INTERVAL.toNanos()) {
        written = System.nanoTime();
        write(observer);
      }
    } catch (StoreException e) {
      log.warn("Loads and paths for replays could not be stored; they wait.", e);
    }
  }

  private void write(SceneObserver from) {
    SceneObserver.Changes changes = from.changes();
    if (changes.isEmpty()) {
      return;
    }
    try {
      store.save(changes.loads(), changes.paths());
      from.forgetChanges();
    } catch (StoreException e) {
      if (changes.loads().size() + changes.paths().size() > MOST_WAITING) {
        from.forgetChanges(); // a gap in replays, and no memory that grows
      }
      throw e;
    }
  }

  @Override
  public void close() {
    work.close();
    if (observer != null) {
      try {
        write(observer);
      } catch (StoreException e) {
        log.warn("The last loads and paths for replays could not be stored.", e);
      }
    }
  }
}
