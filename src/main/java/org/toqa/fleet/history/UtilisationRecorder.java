package org.toqa.fleet.history;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.PeriodicWork;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.persistence.StoreException;

/**
 * Writes down what robots do, on a thread of its own. A killed server loses the last half minute of
 * it; while the store does not answer, what is newest waits.
 */
public final class UtilisationRecorder implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(UtilisationRecorder.class);
  private static final Duration OBSERVE_INTERVAL = Duration.ofMillis(200);
  private static final Duration WRITE_INTERVAL = Duration.ofSeconds(30);
  private static final int MAX_WAITING = 10_000;

  private final SnapshotFeed feed;
  private final UtilisationStore store;
  private final InstantSource clock;
  private final double pace;
  private final Map<String, UtilisationMeter> meters = new HashMap<>();

  /** Records that are over. */
  private final List<UtilisationRecord> waiting = new ArrayList<>();

  private final PeriodicWork work;
  private long written = System.nanoTime();

  /**
   * @param pace as {@link org.toqa.fleet.FleetRules} has it
   */
  public UtilisationRecorder(
      SnapshotFeed feed, UtilisationStore store, InstantSource clock, double pace) {
    this.feed = feed;
    this.store = store;
    this.clock = clock;
    this.pace = pace;
    work = new PeriodicWork("use", OBSERVE_INTERVAL, this::observe);
  }

  private void observe() {
    Instant now = clock.instant();
    feed.latest()
        .robots()
        .forEach(
            robot ->
                meters
                    .computeIfAbsent(robot.name(), name -> new UtilisationMeter(robot, now, pace))
                    .observe(robot, now)
                    .ifPresent(waiting::add));
    if (System.nanoTime() - written > WRITE_INTERVAL.toNanos()) {
      write();
      written = System.nanoTime();
    }
  }

  private void write() {
    List<UtilisationRecord> records = new ArrayList<>(waiting);
    meters.values().forEach(meter -> records.add(meter.record()));
    try {
      store.save(records);
      waiting.clear();
    } catch (StoreException e) {
      log.warn("What robots did could not be stored; it waits.", e);
      if (waiting.size() > MAX_WAITING) {
        waiting.subList(0, waiting.size() - MAX_WAITING).clear();
      }
    }
  }

  @Override
  public void close() {
    work.close();
  }
}
