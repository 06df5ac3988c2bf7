package org.toqa.avoidance;

import java.util.List;
import java.util.Optional;
import org.toqa.geometry.Vec2;

/**
 * The first contact of a disc that drives with one that moves.
 *
 * @param seconds from now
 * @param place of the driving disc's centre, metres, map frame
 * @param obstacle the one that it touches
 */
public record Encounter(double seconds, Vec2 place, MovingDisc obstacle) {

  /** Where a disc's centre is at a moment: seconds from now, and metres in the map frame. */
  public record TimedPoint(double seconds, Vec2 position) {}

  /**
   * The first contact on a line that is driven from point to point, at constant speed between; none
   * before the first point, or after the last one.
   *
   * @param motion by time
   * @param radius of the driving disc, metres, with what shall be kept free round it
   */
  public static Optional<Encounter> first(
      List<TimedPoint> motion, double radius, List<MovingDisc> obstacles) {
    for (int i = 1; i < motion.size(); i++) {
      TimedPoint from = motion.get(i - 1);
      TimedPoint to = motion.get(i);
      Encounter first = null;
      for (MovingDisc obstacle : obstacles) {
        double at = contact(from, to, radius, obstacle);
        if (at < Double.POSITIVE_INFINITY && (first == null || at < first.seconds())) {
          double share = (at - from.seconds()) / Math.max(to.seconds() - from.seconds(), 1e-12);
          Vec2 place = from.position().plus(to.position().minus(from.position()).times(share));
          first = new Encounter(at, place, obstacle);
        }
      }
      if (first != null) {
        return Optional.of(first);
      }
    }
    return Optional.empty();
  }

  /** When two discs touch that both go straight; infinite where they do not. */
  private static double contact(
      TimedPoint from, TimedPoint to, double radius, MovingDisc obstacle) {
    double duration = to.seconds() - from.seconds();
    // |q + w t| = R + d t, from here on
    Vec2 q = from.position().minus(obstacle.positionAt(from.seconds()));
    Vec2 end = to.position().minus(obstacle.positionAt(to.seconds()));
    Vec2 w = duration > 0 ? end.minus(q).times(1 / duration) : Vec2.ZERO;
    double reach = radius + obstacle.reachAt(from.seconds());
    double d = obstacle.drift();
    double c = dot(q, q) - reach * reach;
    if (c < 0) {
      return from.seconds();
    }
    double a = dot(w, w) - d * d;
    double b = dot(q, w) - reach * d;
    double t = firstRoot(a, b, c);
    return t <= duration ? from.seconds() + t : Double.POSITIVE_INFINITY;
  }

  /** The first t from 0 on after which a t^2 + 2 b t + c is below 0, with c not below 0. */
  private static double firstRoot(double a, double b, double c) {
    double discriminant = b * b - a * c;
    if (discriminant <= 0) {
      return a < 0 && c == 0 ? 0 : Double.POSITIVE_INFINITY;
    }
    double root = Math.sqrt(discriminant);
    if (b < 0) {
      return c / (root - b); // without cancelling
    }
    return a < 0 ? (-b - root) / a : Double.POSITIVE_INFINITY;
  }

  private static double dot(Vec2 a, Vec2 b) {
    return a.x() * b.x() + a.y() * b.y();
  }
}
