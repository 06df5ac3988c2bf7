package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * Keeps of one robot's positions those at which its way bends.
 *
 * <p>Every position seen since the last one kept leaves a cone of directions, seen from there, in
 * which a straight line passes it closely enough; a position outside of what all of them have in
 * common means that the one before it is kept. That takes the same few numbers however long the way
 * (Williams, "An efficient algorithm for the piecewise linear approximation of planar curves",
 * 1978). A robot that stands costs nothing.
 */
final class TrackThinner {
  /** Metres that the track may be beside the way. */
  static final double TOLERANCE = 0.10;

  /** A robot that moves leaves a point so often at least, so that times are true on straights. */
  private static final Duration LONGEST = Duration.ofMinutes(1);

  private final String robot;
  private @Nullable TrackPoint kept;
  private @Nullable TrackPoint last;

  /** Radians; the middle of the first cone, from which the others are measured. */
  private double axis = Double.NaN;

  private double least;
  private double most;

  /** Metres from the kept point; who comes nearer again has turned round. */
  private double farthest;

  TrackThinner(String robot) {
    this.robot = robot;
  }

  /** The point to keep, if this position is such that there is one. */
  Optional<TrackPoint> add(Instant at, Vec2 position) {
    TrackPoint now = new TrackPoint(robot, at, position);
    if (kept == null || last == null) {
      return Optional.of(keep(now, now));
    }
    double distance = kept.position().distanceTo(position);
    boolean isLate = distance > TOLERANCE && Duration.between(kept.at(), at).compareTo(LONGEST) > 0;
    if (isLate || distance < farthest - TOLERANCE || !narrow(kept.position(), position, distance)) {
      return Optional.of(keep(last, now));
    }
    farthest = Math.max(farthest, distance);
    last = now;
    return Optional.empty();
  }

  private TrackPoint keep(TrackPoint point, TrackPoint now) {
    kept = point;
    last = now;
    axis = Double.NaN;
    farthest = point.position().distanceTo(now.position());
    narrow(point.position(), now.position(), farthest);
    return point;
  }

  /** False where the position is outside of the cone. */
  private boolean narrow(Vec2 from, Vec2 to, double distance) {
    if (distance <= TOLERANCE) {
      return true;
    }
    double direction = Math.atan2(to.y() - from.y(), to.x() - from.x());
    double half = Math.asin(TOLERANCE / distance);
    if (Double.isNaN(axis)) {
      axis = direction;
      least = -half;
      most = half;
      return true;
    }
    double side = Math.IEEEremainder(direction - axis, 2 * Math.PI);
    if (side < least || side > most) {
      return false;
    }
    least = Math.max(least, side - half);
    most = Math.min(most, side + half);
    return true;
  }
}
