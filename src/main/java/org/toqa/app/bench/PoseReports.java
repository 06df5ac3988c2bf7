package org.toqa.app.bench;

import java.time.Instant;
import java.time.InstantSource;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.toqa.geometry.Pose;

/**
 * When robots reported where they were: a pose that is seen later, with every digit, is found here
 * again. Only a pose's first report counts: a robot that stands reports the same again and again.
 * Thread-safe.
 */
final class PoseReports {
  /** Of each robot, at least 20 s. */
  private static final int KEPT = 200;

  private final Map<String, Map<Pose, Instant>> reports = new ConcurrentHashMap<>();
  private final InstantSource clock;

  PoseReports(InstantSource clock) {
    this.clock = clock;
  }

  /** The robot reports it now. */
  void add(String robot, Pose pose) {
    Instant now = clock.instant();
    Map<Pose, Instant> own = reports.computeIfAbsent(robot, name -> new LinkedHashMap<>());
    synchronized (own) {
      own.putIfAbsent(pose, now);
      if (own.size() > KEPT) {
        own.remove(own.keySet().iterator().next());
      }
    }
  }

  /** When the robot reported it first; empty where it did not, or too long ago. */
  Optional<Instant> find(String robot, Pose pose) {
    Map<Pose, Instant> own = reports.get(robot);
    if (own == null) {
      return Optional.empty();
    }
    synchronized (own) {
      return Optional.ofNullable(own.get(pose));
    }
  }
}
