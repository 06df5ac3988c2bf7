package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
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

  /** Looks at all robots; a cycle counts once it has lasted. */
  void update(Collection<TrafficRobot> robots, Instant now) {
    Map<String, TrafficRobot> byName = new HashMap<>();
    robots.forEach(robot -> byName.put(robot.name, robot));
    List<Standstill> seen = new ArrayList<>();
    Set<String> stalled = new HashSet<>();
    for (TrafficRobot robot : robots) {
      if (robot.isStalled() && robot.isMovable()) {
        stalled.add(robot.name);
        Instant since = notMoving.computeIfAbsent(robot.name, name -> now);
        seen.add(standstill(Standstill.Kind.NOT_MOVING, List.of(robot), since));
      }
    }
    notMoving.keySet().retainAll(stalled);
    Set<Set<String>> found = new HashSet<>();
    for (TrafficRobot robot : robots) {
      List<TrafficRobot> cycle = cycleFrom(robot, byName);
      Set<String> names = new HashSet<>();
      cycle.forEach(c -> names.add(c.name));
      if (!cycle.isEmpty() && found.add(names)) {
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

  /** The cycle of waits that the robot is the first of by name, or nothing. */
  private static List<TrafficRobot> cycleFrom(
      TrafficRobot first, Map<String, TrafficRobot> byName) {
    List<TrafficRobot> chain = new ArrayList<>();
    TrafficRobot at = first;
    while (at != null && !chain.contains(at)) {
      chain.add(at);
      at = blockingRobot(at, byName);
    }
    boolean isCycle = at == first;
    boolean isFirstByName = chain.stream().noneMatch(robot -> robot.name.compareTo(first.name) < 0);
    return isCycle && isFirstByName ? chain : List.of();
  }

  private static @Nullable TrafficRobot blockingRobot(
      TrafficRobot robot, Map<String, TrafficRobot> byName) {
    WaitReason reason = robot.drive.isDriving() ? null : robot.waitReason();
    String other = reason == null ? null : reason.robot();
    return other == null ? null : byName.get(other);
  }
}
