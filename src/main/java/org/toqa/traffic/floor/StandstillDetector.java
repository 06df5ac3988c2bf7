package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.Cell;

/**
 * Watches what robots really do, whatever was planned: who has not moved for longer than its path
 * says, and who waits for whom in a circle (a cycle of the wait-for graph: Coffman et al., "System
 * deadlocks", 1971).
 */
final class StandstillDetector {
  private static final Duration CYCLE_AFTER = Duration.ofSeconds(2);
  private static final Duration NOT_MOVING_AFTER = Duration.ofSeconds(10);

  /** A robot may need so many times as long as its path says. */
  private static final double SLOWNESS_FACTOR = 3;

  /** Cycles, by their robots, and when each was first seen. */
  private final Map<Set<String>, Instant> cycles = new HashMap<>();

  private final Map<String, Instant> notMoving = new HashMap<>();
  private List<Standstill> standstills = List.of();

  /** What was seen last, a robot in one of them at most. */
  List<Standstill> standstills() {
    return standstills;
  }

  /** Whether the robot has not gone on for much longer than its path says. */
  static boolean isNotMoving(TrafficRobot robot, Instant now) {
    ReservedPath path = robot.drive.path();
    if (path == null || !robot.drive.isDriving()) {
      return false;
    }
    double planned = path.sections().get(robot.drive.completed()).duration();
    Duration patience = NOT_MOVING_AFTER.plusMillis((long) (1000 * SLOWNESS_FACTOR * planned));
    return robot.drive.lastProgress().plus(patience).isBefore(now);
  }

  /**
   * Looks at all robots; a cycle counts once it has lasted.
   *
   * @param robots all, by name
   */
  void update(Map<String, TrafficRobot> robots, Instant now) {
    List<Standstill> seen = new ArrayList<>();
    Set<String> stalled = new HashSet<>();
    for (TrafficRobot robot : robots.values()) {
      if (robot.isStalled() && robot.isMovable()) {
        stalled.add(robot.name);
        Instant since = notMoving.computeIfAbsent(robot.name, name -> now);
        seen.add(standstill(Standstill.Kind.NOT_MOVING, List.of(robot), since));
      }
    }
    notMoving.keySet().retainAll(stalled);
    Set<Set<String>> found = new HashSet<>();
    for (List<TrafficRobot> cycle : cycles(robots)) {
      Set<String> names = new HashSet<>();
      cycle.forEach(c -> names.add(c.name));
      if (found.add(names)) {
        Instant since = cycles.computeIfAbsent(names, key -> now);
        if (!since.plus(CYCLE_AFTER).isAfter(now)) {
          seen.add(standstill(Standstill.Kind.CYCLE_OF_WAITS, cycle, since));
        }
      }
    }
    cycles.keySet().retainAll(found);
    standstills = List.copyOf(seen);
  }

  private static Standstill standstill(
      Standstill.Kind kind, List<TrafficRobot> robots, Instant since) {
    List<Cell> cells = robots.stream().map(TrafficRobot::cell).toList();
    return new Standstill(kind, robots.stream().map(robot -> robot.name).toList(), cells, since);
  }

  /**
   * All cycles of waits, each from its first robot by name. Each robot waits for one at most, so
   * each is looked at once: a chain that comes to one seen in an earlier chain brings nothing new.
   */
  private static List<List<TrafficRobot>> cycles(Map<String, TrafficRobot> robots) {
    List<List<TrafficRobot>> all = new ArrayList<>();
    Set<TrafficRobot> seen = new HashSet<>();
    for (TrafficRobot first : robots.values()) {
      if (blockingRobot(first, robots) == null) {
        continue; // it is in no cycle
      }
      Map<TrafficRobot, Integer> chain = new LinkedHashMap<>();
      TrafficRobot at = first;
      while (at != null && seen.add(at)) {
        chain.put(at, chain.size());
        at = blockingRobot(at, robots);
      }
      Integer begin = at == null ? null : chain.get(at);
      if (begin != null) {
        List<TrafficRobot> cycle = new ArrayList<>(chain.keySet()).subList(begin, chain.size());
        TrafficRobot least = Collections.min(cycle, Comparator.comparing(robot -> robot.name));
        Collections.rotate(cycle, -cycle.indexOf(least));
        all.add(cycle);
      }
    }
    all.sort(Comparator.comparing(cycle -> cycle.getFirst().name));
    return all;
  }

  private static @Nullable TrafficRobot blockingRobot(
      TrafficRobot robot, Map<String, TrafficRobot> robots) {
    WaitReason reason = robot.drive.isDriving() ? null : robot.waitReason();
    String other = reason == null ? null : reason.robot();
    return other == null ? null : robots.get(other);
  }
}
