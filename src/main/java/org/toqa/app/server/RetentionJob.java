package org.toqa.app.server;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.PeriodicWork;
import org.toqa.persistence.StoreException;
import org.toqa.store.HistoryPruner;

/** Prunes the store every hour, on a thread of its own. */
final class RetentionJob implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(RetentionJob.class);
  private static final Duration PERIOD = Duration.ofHours(1);

  private final HistoryPruner pruner;
  private final Duration trackRetention;
  private final Duration historyRetention;
  private final InstantSource clock;
  private final PeriodicWork work;

  RetentionJob(
      HistoryPruner pruner,
      Duration trackRetention,
      Duration historyRetention,
      InstantSource clock) {
    this.pruner = pruner;
    this.trackRetention = trackRetention;
    this.historyRetention = historyRetention;
    this.clock = clock;
    work = new PeriodicWork("housekeeping", PERIOD, this::prune);
  }

  private void prune() {
    Instant now = clock.instant();
    try {
      long points = pruner.pruneTracks(now.minus(trackRetention));
      long tasks = pruner.pruneHistory(now.minus(historyRetention));
      if (points + tasks > 0) {
        log.info("Pruned {} points of tracks and {} ended tasks.", points, tasks);
      }
    } catch (StoreException e) {
      log.warn("Nothing could be pruned; it is tried again in an hour.", e);
    }
  }

  @Override
  public void close() {
    work.close();
  }
}
