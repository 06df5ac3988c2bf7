package org.toqa.fleet.history;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** Adds up the distance that a robot drives, from where it is seen. */
final class Odometer {
  /** Metres; a shorter distance may be noise of a stopped robot's pose. */
  private static final double STEP = 0.05;

  /** Who is seen farther off than so many times what it can drive was put there, or put right. */
  private static final double HASTE = 2;

  private @Nullable Instant lastSeenAt;
  private Vec2 lastSeen = Vec2.ZERO;

  /** Up to here its distance is counted. */
  private Vec2 counted = Vec2.ZERO;

  /**
   * Metres that are to be added now.
   *
   * @param speed metres at which it drives straight on, in a second of what {@code at} counts
   */
  double add(Instant at, Vec2 position, double speed) {
    boolean isContinued = lastSeenAt != null && isWithinReach(lastSeenAt, at, position, speed);
    lastSeenAt = at;
    lastSeen = position;
    double distance = isContinued ? counted.distanceTo(position) : 0;
    if (isContinued && distance < STEP) {
      return 0;
    }
    counted = position;
    return distance;
  }

  private boolean isWithinReach(Instant before, Instant at, Vec2 position, double speed) {
    double seconds = Duration.between(before, at).toMillis() / 1000.0;
    return lastSeen.distanceTo(position) <= STEP + HASTE * speed * seconds;
  }
}
