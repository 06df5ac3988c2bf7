package org.toqa.app.bench;

import java.util.SplittableRandom;
import org.toqa.geometry.Vec2;

/**
 * How far a robot is beside where it takes itself to be, as between two marks on the floor: it
 * changes while the robot drives, by a small share of the way, and never exceeds a bound.
 */
final class PoseError {
  /** Metres a metre. */
  private static final double DRIFT = 0.02;

  private final double bound;
  private final SplittableRandom random;
  private Vec2 offset;
  private Vec2 target;

  /**
   * @param bound metres, at least 0
   */
  PoseError(double bound, long seed) {
    this.bound = bound;
    this.random = new SplittableRandom(seed);
    offset = anywhere();
    target = anywhere();
  }

  /** From where it takes itself to be to where it is, metres, map frame. */
  Vec2 offset() {
    return offset;
  }

  /**
   * It has driven on.
   *
   * @param metres at least 0
   */
  void advance(double metres) {
    Vec2 left = target.minus(offset);
    double distance = Math.hypot(left.x(), left.y());
    double step = DRIFT * metres;
    if (step < distance) {
      offset = offset.plus(left.times(step / distance));
    } else if (bound > 0) {
      offset = target;
      target = anywhere();
    }
  }

  /** Each place of the disc as likely. */
  private Vec2 anywhere() {
    double radius = bound * Math.sqrt(random.nextDouble());
    double angle = random.nextDouble(2 * Math.PI);
    return new Vec2(radius * Math.cos(angle), radius * Math.sin(angle));
  }
}
