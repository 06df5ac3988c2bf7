package org.toqa.fleet.history;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * Keeps of one robot's positions those at which its track bends or its speed changes.
 *
 * <p>Every position seen since the last one kept leaves, along each axis, a range of even speeds
 * that pass it closely enough at its moment; a position outside of what all of them have in common
 * means that the one before it is kept. That takes the same few numbers however long the track (the
 * swing filter of Elmeleegy, Elmagarmid, Cecchet, Aref and Zwaenepoel, "Online piece-wise linear
 * approximation of numerical streams with precision guarantees", 2009). A robot that is stopped
 * costs nothing.
 */
final class TrackThinner {
  /** Metres along each axis by which the track may be beside where the robot was at a moment. */
  static final double TOLERANCE = 0.10;

  /** A robot that moves leaves a point so often at least. */
  private static final Duration LONGEST = Duration.ofMinutes(1);

  private final String robot;
  private @Nullable TrackPoint kept;
  private @Nullable TrackPoint last;
  private Speeds alongX = Speeds.ANY;
  private Speeds alongY = Speeds.ANY;

  /** Metres a second. */
  private record Speeds(double least, double most) {
    static final Speeds ANY = new Speeds(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

    boolean contains(double speed) {
      return least <= speed && speed <= most;
    }

    Speeds narrowed(double speed, double reach) {
      return new Speeds(Math.max(least, speed - reach), Math.min(most, speed + reach));
    }
  }

  TrackThinner(String robot) {
    this.robot = robot;
  }

  /** The point to keep, if this position is such that there is one. */
  Optional<TrackPoint> add(Instant at, Vec2 position) {
    TrackPoint now = new TrackPoint(robot, at, position);
    if (kept == null || last == null) {
      kept = now;
      last = now;
      return Optional.of(now);
    }
    if (!at.isAfter(last.at())) {
      return Optional.empty(); // nothing has been heard since
    }
    if (last.equals(kept) || isOnLine(kept, now)) {
      narrow(kept, now);
      last = now;
      return Optional.empty();
    }
    TrackPoint bend = last;
    alongX = Speeds.ANY;
    alongY = Speeds.ANY;
    narrow(bend, now);
    kept = bend;
    last = now;
    return Optional.of(bend);
  }

  private boolean isOnLine(TrackPoint from, TrackPoint to) {
    boolean isLate =
        from.position().distanceTo(to.position()) > TOLERANCE
            && Duration.between(from.at(), to.at()).compareTo(LONGEST) > 0;
    Vec2 speed = speed(from, to);
    return !isLate && alongX.contains(speed.x()) && alongY.contains(speed.y());
  }

  private void narrow(TrackPoint from, TrackPoint to) {
    Vec2 speed = speed(from, to);
    double reach = TOLERANCE / seconds(from, to);
    alongX = alongX.narrowed(speed.x(), reach);
    alongY = alongY.narrowed(speed.y(), reach);
  }

  private static Vec2 speed(TrackPoint from, TrackPoint to) {
    return to.position().minus(from.position()).times(1 / seconds(from, to));
  }

  private static double seconds(TrackPoint from, TrackPoint to) {
    return Duration.between(from.at(), to.at()).toNanos() / 1e9;
  }
}
