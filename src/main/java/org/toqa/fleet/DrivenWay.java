package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** Adds up the way that a robot drives, from where it is seen. */
final class DrivenWay {
  /** Metres; what is nearer may be the shiver of one that stands. */
  private static final double STEP = 0.05;

  /** Who is seen farther off than so many times what it can drive was put there, or put right. */
  private static final double HASTE = 2;

  private @Nullable Instant seenAt;
  private Vec2 seen = Vec2.ZERO;

  /** Up to here its way is counted. */
  private Vec2 counted = Vec2.ZERO;

  /**
   * Metres that are to be added now.
   *
   * @param speed metres at which it drives straight on, in a second of what {@code at} counts
   */
  double add(Instant at, Vec2 position, double speed) {
    boolean isContinued = seenAt != null && isWithinReach(seenAt, at, position, speed);
    seenAt = at;
    seen = position;
    double way = isContinued ? counted.distanceTo(position) : 0;
    if (isContinued && way < STEP) {
      return 0;
    }
    counted = position;
    return way;
  }

  private boolean isWithinReach(Instant before, Instant at, Vec2 position, double speed) {
    double seconds = Duration.between(before, at).toMillis() / 1000.0;
    return seen.distanceTo(position) <= STEP + HASTE * speed * seconds;
  }
}
