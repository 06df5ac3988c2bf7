package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetStore.StoreException;

/**
 * Writes down what robots do, on a thread of its own. A killed server loses the last half minute of
 * it; while the store does not answer, what is newest waits.
 */
public final class UseRecorder implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(UseRecorder.class);
  private static final Duration LOOK_EVERY = Duration.ofMillis(200);
  private static final Duration WRITE_EVERY = Duration.ofSeconds(30);
  private static final int MOST_WAITING = 10_000;

  private final SnapshotFeed feed;
  private final UseStore store;
  private final InstantSource clock;
  private final double pace;
  private final Map<String, UseMeter> meters = new HashMap<>();

  /** Records that are over. */
  private final List<UseRecord> waiting = new ArrayList<>();

  private final PacedWork work;
  private long written = System.nanoTime();

  /**
   * @param pace as {@link FleetRules} has it
   */
  public UseRecorder(SnapshotFeed feed, UseStore store, InstantSource clock, double pace) {
    this.feed = feed;
    this.store = store;
    this.clock = clock;
    this.pace = pace;
    work = new PacedWork("use", LOOK_EVERY, this::look);
  }

  private void look() {
    Instant now = clock.instant();
    feed.latest()
        .robots()
        .forEach(
            robot ->
                meters
                    .computeIfAbsent(robot.name(), name -> new UseMeter(robot, now, pace))
                    .look(robot, now)
                    .ifPresent(waiting::add));
    if (System.nanoTime() - written > WRITE_EVERY.toNanos()) {
      write();
      written = System.nanoTime();
    }
  }

  private void write() {
    List<UseRecord> records = new ArrayList<>(waiting);
    meters.values().forEach(meter -> records.add(meter.record()));
    try {
      store.save(records);
      waiting.clear();
    } catch (StoreException e) {
      log.warn("What robots did could not be stored; it waits.", e);
      if (waiting.size() > MOST_WAITING) {
        waiting.subList(0, waiting.size() - MOST_WAITING).clear();
      }
    }
  }

  @Override
  public void close() {
    work.close();
  }
}
