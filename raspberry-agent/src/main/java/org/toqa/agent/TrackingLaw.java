package org.toqa.agent;

import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * How an omnidirectional robot follows a moving reference: the reference's velocity fed forward,
 * and a bounded velocity towards it in proportion to the error, in each of x, y and heading. Time
 * constant 1/3 s, well above the 20 ms of a tick and the lag of the motors.
 */
final class TrackingLaw {

  private static final double GAIN = 3;

  /** Metres a second, radians a second: no error, however large, makes a robot leap. */
  private static final double MOST_CORRECTION = 0.1;

  private static final double MOST_TURN_CORRECTION = 0.5;

  private TrackingLaw() {}

  /**
   * @param reference map frame
   * @param referenceTwist in the reference's own frame
   * @param actual map frame
   * @return the velocity to command, in the robot's frame
   */
  static Twist towards(Pose reference, Twist referenceTwist, Pose actual) {
    Vec2 feedForward =
        new Vec2(referenceTwist.vx(), referenceTwist.vy()).rotated(reference.theta());
    Vec2 correction = bounded(reference.position().minus(actual.position()).times(GAIN));
    Vec2 wanted = feedForward.plus(correction).rotated(-actual.theta());
    double turn = GAIN * Angles.difference(actual.theta(), reference.theta());
    return new Twist(
        wanted.x(),
        wanted.y(),
        referenceTwist.w() + Math.clamp(turn, -MOST_TURN_CORRECTION, MOST_TURN_CORRECTION));
  }

  private static Vec2 bounded(Vec2 velocity) {
    double norm = velocity.norm();
    return norm <= MOST_CORRECTION ? velocity : velocity.times(MOST_CORRECTION / norm);
  }
}
