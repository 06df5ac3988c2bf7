package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.function.Supplier;
import org.toqa.fleet.RateLimit;
import org.toqa.fleet.RobotMessageKind;
import org.toqa.fleet.robot.AgentHealth;
import org.toqa.fleet.robot.FloodMeter;

/** How much one robot may cause to be stored. Confined to its floor's agent. */
final class StoreLimit {
  /** Of the history. */
  private static final int LINES_A_MINUTE = 30;

  /** At once; later one a second: a robot without a drive stands. */
  private static final int PLACES = 5;

  private final Supplier<Instant> now;
  private final FloodMeter meter;
  private final RateLimit lines;
  private final RateLimit places;

  /**
   * @param now of the time that ticks bring
   */
  StoreLimit(AgentHealth health, Supplier<Instant> now) {
    this.now = now;
    meter = new FloodMeter(health);
    lines = new RateLimit(LINES_A_MINUTE, LINES_A_MINUTE, Duration.ofMinutes(1), now);
    places = new RateLimit(PLACES, 1, Duration.ofSeconds(1), now);
  }

  /** What becomes of a line of the history. */
  enum Verdict {
    WRITE,
    LEAVE_OUT,
    /** The first that is left out: people are told that there are too many. */
    LEAVE_OUT_AND_TELL
  }

  Verdict judgeLine() {
    if (lines.tryAcquire()) {
      return Verdict.WRITE;
    }
    return meter.record(RobotMessageKind.EVENT, 1, now.get())
        ? Verdict.LEAVE_OUT_AND_TELL
        : Verdict.LEAVE_OUT;
  }

  /** Whether it is time to store where the robot is. */
  boolean takesPlace() {
    return places.tryAcquire();
  }

  /** Whether there have just been no more than there may be for long enough. */
  boolean detectRecovery() {
    return meter.detectRecovery(now.get());
  }
}
