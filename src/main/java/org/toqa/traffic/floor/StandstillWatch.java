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
 * Watches what robots really do, whatever was planned: who has not moved for longer than its way
 * says, and who waits for whom in a circle.
 */
final class StandstillWatch {
  private static final Duration CYCLE_AFTER = Duration.ofSeconds(2);
  private static final Duration NOT_MOVING_AFTER = Duration.ofSeconds(10);

  /** A robot may need so many times as long as its way says. */
  private static final double SLOWNESS = 3;

  /** Cycles, by their robots, and when each was first seen. */
  private final Map<Set<String>, Instant> cycles = new HashMap<>();

  private final Map<String, Instant> notMoving = new HashMap<>();
  private List<Standstill> standstills = List.of();

  /** What was seen last, a robot in one of them at most. */
  List<Standstill> standstills() {
    return standstills;
  }

  /** Whether the robot has not gone on for much longer than its way says. */
  static boolean isNotMoving(Mover m, Instant now) {
    Course course = m.course;
    if (course == null || !m.isDriving()) {
      return false;
    }
    double planned = course.stretches().get(m.done).duration();
    Duration patience = NOT_MOVING_AFTER.plusMillis((long) (1000 * SLOWNESS * planned));
    return m.lastProgress.plus(patience).isBefore(now);
  }

  /** Looks at all robots; a cycle counts once it has lasted. */
  void look(Collection<Mover> movers, Instant now) {
    Map<String, Mover> byName = new HashMap<>();
    movers.forEach(m -> byName.put(m.name, m));
    List<Standstill> seen = new ArrayList<>();
    Set<String> stalled = new HashSet<>();
    for (Mover m : movers) {
      if (m.stalled && m.movable) {
        stalled.add(m.name);
        Instant since = notMoving.computeIfAbsent(m.name, name -> now);
        seen.add(standstill(Standstill.Kind.NOT_MOVING, List.of(m), since));
      }
    }
    notMoving.keySet().retainAll(stalled);
    Set<Set<String>> found = new HashSet<>();
    for (Mover m : movers) {
      List<Mover> cycle = cycleFrom(m, byName);
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

  private static Standstill standstill(Standstill.Kind kind, List<Mover> movers, Instant since) {
    List<Cell> cells = movers.stream().map(Mover::cell).toList();
    return new Standstill(kind, movers.stream().map(m -> m.name).toList(), cells, since);
  }

  /** The cycle of waits that the robot is the first of by name, or nothing. */
  private static List<Mover> cycleFrom(Mover first, Map<String, Mover> byName) {
    List<Mover> chain = new ArrayList<>();
    Mover at = first;
    while (at != null && !chain.contains(at)) {
      chain.add(at);
      at = waitsFor(at, byName);
    }
    boolean isCycle = at == first;
    boolean isFirstByName = chain.stream().noneMatch(m -> m.name.compareTo(first.name) < 0);
    return isCycle && isFirstByName ? chain : List.of();
  }

  private static @Nullable Mover waitsFor(Mover m, Map<String, Mover> byName) {
    Hindrance why = m.isDriving() ? null : m.why();
    String other = why == null ? null : why.robot();
    return other == null ? null : byName.get(other);
  }
}
