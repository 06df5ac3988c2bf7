package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Tells a floor the time, one tick after the other. While it is still at its last one it is told
 * nothing, and the newest time when it has done that, so that ticks neither pile up before it nor
 * are left out: a simulated world waits for what its next one brings. A floor that has neither
 * robots nor tasks is told once a second: that is often enough to forget what was seen there.
 */
final class FloorTicks {
  private static final Duration IDLE_PERIOD = Duration.ofSeconds(1);

  private final Consumer<Instant> floor;
  private final LongSupplier monotonicNanos;

  /** Null: none. */
  private @Nullable Running running;

  /** Whether there is another one to do after it. */
  private boolean isDue;

  private Instant now = Instant.MIN;

  /** From then on a floor that is idle is told again. */
  private Instant nextIdle = Instant.MIN;

  /**
   * @param since nanoseconds of a clock that never jumps
   */
  private record Running(Instant tick, long since) {}

  /**
   * @param floor is told the time
   */
  FloorTicks(Consumer<Instant> floor, LongSupplier monotonicNanos) {
    this.floor = floor;
    this.monotonicNanos = monotonicNanos;
  }

  /** Whether the floor is still at its tick. */
  boolean isRunning() {
    return running != null;
  }

  /** Since when its tick runs, nanoseconds of a clock that never jumps. */
  OptionalLong runningSince() {
    Running current = running;
    return current == null ? OptionalLong.empty() : OptionalLong.of(current.since());
  }

  /** The time that the floor is at: of the tick that runs, or else of the last one. */
  Instant floorTime() {
    Running current = running;
    return current == null ? now : current.tick();
  }

  /**
   * @param isIdle whether the floor has neither robots nor tasks
   */
  void tick(Instant time, boolean isIdle) {
    now = time;
    if (running != null) {
      isDue = true;
    } else if (!isIdle || !time.isBefore(nextIdle)) {
      begin();
    }
  }

  /** The floor has done its tick. */
  void end() {
    running = null;
    if (isDue) {
      isDue = false;
      begin();
    }
  }

  private void begin() {
    nextIdle = now.plus(IDLE_PERIOD);
    running = new Running(now, monotonicNanos.getAsLong());
    floor.accept(now);
  }
}
