package org.toqa.avoidance;

import org.toqa.geometry.Vec2;

/**
 * An obstacle that moves, as it was told at a moment, time 0.
 *
 * @param position of its centre, metres, map frame
 * @param velocity metres a second, map frame
 * @param radius metres
 * @param drift metres a second by which it may stray from where that velocity leads; 0 where it is
 *     known to go on as told
 */
public record MovingDisc(Vec2 position, Vec2 velocity, double radius, double drift) {

  /** Where its centre is expected, metres, map frame. */
  public Vec2 positionAt(double seconds) {
    return position.plus(velocity.times(seconds));
  }

  /** All of it is within so many metres of there. */
  public double reachAt(double seconds) {
    return radius + drift * seconds;
  }

  /** The same as it is told at a later moment, if nothing new is known. */
  public MovingDisc after(double seconds) {
    return new MovingDisc(positionAt(seconds), velocity, reachAt(seconds), drift);
  }
}
