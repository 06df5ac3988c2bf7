package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.Mission;

/**
 * Since when a robot waits at a stop, by the time that ticks bring: a clock that is set neither
 * ends nor prolongs it. When it began is asked of the clock only where it had begun before, as
 * after a restart.
 */
final class StopWait {
  /** Null: it does not wait. */
  private @Nullable Began began;

  /**
   * @param by the clock
   * @param from of the time that ticks bring
   */
  private record Began(long task, int stop, Instant by, Instant from) {}

  /**
   * To be told at every tick.
   *
   * @param clock what the clock says
   * @param now of the time that ticks bring
   * @param pace seconds of it in a second of the clock
   */
  void update(Mission mission, Instant clock, Instant now, double pace) {
    Instant since = mission.progress().waitingSince();
    if (since == null) {
      began = null;
      return;
    }
    int stop = mission.progress().stop();
    Began before = began;
    if (before == null
        || before.task() != mission.id()
        || before.stop() != stop
        || !Objects.equals(before.by(), since)) {
      Instant from = now.minus(mission.progress().waited(clock, pace));
      began = new Began(mission.id(), stop, since, from);
    }
  }

  /** Zero where it does not wait. */
  Duration waited(Instant now) {
    return began == null ? Duration.ZERO : Duration.between(began.from(), now);
  }
}
