package org.toqa.app.bench;

import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.ReadWriteLock;
import java.util.concurrent.locks.ReentrantReadWriteLock;
import org.jspecify.annotations.Nullable;
import org.toqa.app.bench.meter.LatencyHistogram;
import org.toqa.app.bench.meter.LatencySummary;
import org.toqa.geometry.Pose;
import tools.jackson.databind.JsonNode;

/**
 * How long poses take from the robots that report them to those who watch, and to the server on
 * their way. Thread-safe.
 */
final class PoseLatencies {
  private final PoseReports reports;
  private final LatencyHistogram heard = new LatencyHistogram();
  private final LatencyHistogram streamed = new LatencyHistogram();
  private final LatencyHistogram seen = new LatencyHistogram();
  private final AtomicLong unmatched = new AtomicLong();

  /** Shared by the watchers, who add all of a pose or nothing before a summary. */
  private final ReadWriteLock lock = new ReentrantReadWriteLock();

  /**
   * @param heard from a robot's report until the server had heard it
   * @param streamed from there until a watcher had it
   * @param seen from a robot's report until a watcher had it
   * @param unmatched how many poses were seen that no robot has reported
   */
  record Summary(
      LatencySummary heard, LatencySummary streamed, LatencySummary seen, long unmatched) {}

  PoseLatencies(PoseReports reports) {
    this.reports = reports;
  }

  /** Somebody who watches: what he saw last. For one thread. */
  final class Watcher {
    private final Map<String, String> lastHeard = new HashMap<>();
    private final Map<String, Pose> lastPoses = new HashMap<>();

    /**
     * He has received an event, a snapshot or what has changed since.
     *
     * @param now when he had read it
     */
    void receive(JsonNode event, Instant now) {
      for (JsonNode robot : event.path("robots")) {
        String name = robot.path("name").asString();
        String heardAt = robot.path("lastSeen").asString("");
        if (!heardAt.isEmpty() && !heardAt.equals(lastHeard.put(name, heardAt))) {
          Instant serverHeard = Instant.parse(heardAt);
          lock.readLock().lock();
          try {
            streamed.add(serverHeard, now);
            receivePose(name, poseOf(robot), serverHeard, now);
          } finally {
            lock.readLock().unlock();
          }
        }
      }
    }

    private void receivePose(String name, @Nullable Pose pose, Instant serverHeard, Instant now) {
      Pose before = pose == null ? null : lastPoses.put(name, pose);
      if (pose == null || before == null || before.equals(pose)) {
        return;
      }
      Optional<Instant> reported = reports.find(name, pose);
      if (reported.isEmpty()) {
        unmatched.incrementAndGet();
      } else {
        heard.add(reported.get(), serverHeard);
        seen.add(reported.get(), now);
      }
    }
  }

  /** What a robot's part of an event says; null: nothing. */
  static @Nullable Pose poseOf(JsonNode robot) {
    JsonNode pose = robot.path("pose");
    return pose.isObject()
        ? new Pose(
            pose.path("x").asDouble(), pose.path("y").asDouble(), pose.path("theta").asDouble())
        : null;
  }

  /** What was measured so far, all of it at the same moment. */
  Summary summary() {
    lock.writeLock().lock();
    try {
      return new Summary(heard.summary(), streamed.summary(), seen.summary(), unmatched.get());
    } finally {
      lock.writeLock().unlock();
    }
  }

  /** Discards what was measured so far. */
  void reset() {
    lock.writeLock().lock();
    try {
      heard.reset();
      streamed.reset();
      seen.reset();
      unmatched.set(0);
    } finally {
      lock.writeLock().unlock();
    }
  }
}
