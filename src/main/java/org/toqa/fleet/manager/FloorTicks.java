package org.toqa.fleet.manager;

import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.LongSupplier;

/**
 * Tells floors the time, one tick after the other. A floor that is still at its last one is told
 * the newest time when it has done that, so that ticks neither pile up before it nor are left out:
 * a simulated world waits for what its next one brings.
 */
final class FloorTicks {
  private final BiConsumer<String, Instant> floors;
  private final LongSupplier monotonicNanos;

  /** By floor whose tick is running. */
  private final Map<String, Running> running = new HashMap<>();

  /** Floors whose tick is running, and that have another one to do. */
  private final Set<String> due = new HashSet<>();

  private Instant now = Instant.MIN;

  /**
   * @param since nanoseconds of a clock that never jumps
   */
  private record Running(Instant tick, long since) {}

  /**
   * @param floors are told the time, by their names
   */
  FloorTicks(BiConsumer<String, Instant> floors, LongSupplier monotonicNanos) {
    this.floors = floors;
    this.monotonicNanos = monotonicNanos;
  }

  /** Whether a floor is still at its tick. */
  boolean isRunning() {
    return !running.isEmpty();
  }

  /** Since when the oldest tick runs, nanoseconds of a clock that never jumps. */
  OptionalLong runningSince() {
    return running.values().stream().mapToLong(Running::since).min();
  }

  /** The time that floors are at: of the oldest tick that runs, or else of the last one. */
  Instant floorTime() {
    return running.values().stream().map(Running::tick).min(Instant::compareTo).orElse(now);
  }

  void tick(Set<String> all, Instant time) {
    now = time;
    for (String floor : all) {
      if (running.containsKey(floor)) {
        due.add(floor);
      } else {
        begin(floor);
      }
    }
  }

  /** The floor has done its tick. */
  void end(String floor) {
    running.remove(floor);
    if (due.remove(floor)) {
      begin(floor);
    }
  }

  private void begin(String floor) {
    running.put(floor, new Running(now, monotonicNanos.getAsLong()));
    floors.accept(floor, now);
  }
}
