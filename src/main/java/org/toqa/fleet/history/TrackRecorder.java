package org.toqa.fleet.history;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.PeriodicWork;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.RobotView.Telemetry;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.persistence.StoreException;

/**
 * Writes down where robots were and how full their batteries, on a thread of its own. A killed
 * server loses the last ten seconds of it; while the store does not answer, the newest points wait.
 */
public final class TrackRecorder implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(TrackRecorder.class);
  private static final Duration OBSERVE_INTERVAL = Duration.ofMillis(200);
  private static final Duration WRITE_INTERVAL = Duration.ofSeconds(10);
  private static final int MAX_WAITING = 100_000;

  private final SnapshotFeed feed;
  private final TrackStore store;
  private final Map<String, TrackThinner> thinners = new HashMap<>();
  private final List<TrackPoint> waiting = new ArrayList<>();

  /** By robot, the last level that was written down or waits. */
  private final Map<String, BatteryLevel> levels = new HashMap<>();

  private final List<BatteryLevel> waitingLevels = new ArrayList<>();
  private final PeriodicWork work;
  private long written = System.nanoTime();

  public TrackRecorder(SnapshotFeed feed, TrackStore store) {
    this.feed = feed;
    this.store = store;
    work = new PeriodicWork("tracks", OBSERVE_INTERVAL, this::observe);
  }

  private void observe() {
    feed.latest().robots().forEach(this::observe);
    if (System.nanoTime() - written > WRITE_INTERVAL.toNanos()) {
      write();
      written = System.nanoTime();
    }
  }

  private void observe(RobotView robot) {
    Telemetry seen = robot.telemetry();
    if (seen.pose() != null && seen.lastSeen() != null && robot.state() != RobotState.LOST) {
      thinners
          .computeIfAbsent(robot.name(), TrackThinner::new)
          .add(seen.lastSeen(), seen.pose().position())
          .ifPresent(waiting::add);
      observeBattery(robot.name(), seen);
    }
  }

  private void observeBattery(String robot, Telemetry seen) {
    Double battery = seen.battery();
    if (battery == null || seen.lastSeen() == null) {
      return;
    }
    BatteryLevel now = new BatteryLevel(robot, seen.lastSeen(), battery);
    BatteryLevel before = levels.get(robot);
    if (before == null || now.isNewAfter(before)) {
      levels.put(robot, now);
      waitingLevels.add(now);
    }
  }

  private void write() {
    try {
      if (!waiting.isEmpty()) {
        store.add(List.copyOf(waiting));
        waiting.clear();
      }
      if (!waitingLevels.isEmpty()) {
        store.addBatteryLevels(List.copyOf(waitingLevels));
        waitingLevels.clear();
      }
    } catch (StoreException e) {
      log.warn("Tracks could not be stored; they wait.", e);
      dropOldest(waiting);
      dropOldest(waitingLevels);
    }
  }

  private static void dropOldest(List<?> waiting) {
    if (waiting.size() > MAX_WAITING) {
      waiting.subList(0, waiting.size() - MAX_WAITING).clear();
    }
  }

  @Override
  public void close() {
    work.close();
  }
}
