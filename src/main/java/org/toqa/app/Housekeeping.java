package org.toqa.app;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetStore.StoreException;
import org.toqa.fleet.PacedWork;
import org.toqa.store.Pruning;

/** Prunes the store every hour, on a thread of its own. */
final class Housekeeping implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(Housekeeping.class);
  private static final Duration PACE = Duration.ofHours(1);

  private final Pruning pruning;
  private final Duration keepTracks;
  private final Duration keepHistory;
  private final InstantSource clock;
  private final PacedWork work;

  Housekeeping(Pruning pruning, Duration keepTracks, Duration keepHistory, InstantSource clock) {
    this.pruning = pruning;
    this.keepTracks = keepTracks;
    this.keepHistory = keepHistory;
    this.clock = clock;
    work = new PacedWork("housekeeping", PACE, this::prune);
  }

  private void prune() {
    Instant now = clock.instant();
    try {
      long points = pruning.tracks(now.minus(keepTracks));
      long tasks = pruning.history(now.minus(keepHistory));
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
