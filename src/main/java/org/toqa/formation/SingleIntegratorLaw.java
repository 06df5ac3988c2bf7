package org.toqa.formation;

import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * The law for robots that move in any direction: the place's velocity fed forward, and a bounded
 * velocity towards it in proportion to the error, in each of x, y and heading (Tanta, "Formation
 * control": xi' = v1 + kp ((pi - p1) - (xi - x1)), with the pattern turned with the leader's
 * heading, so that a place also moves by the leader's turning).
 */
public record SingleIntegratorLaw(Gains gains) implements FollowerLaw {

  @Override
  public Twist velocity(Pose place, Twist placeTwist, Pose actual) {
    Vec2 feedForward = new Vec2(placeTwist.vx(), placeTwist.vy()).rotated(place.theta());
    Vec2 error = place.position().minus(actual.position());
    Vec2 wanted = feedForward.plus(correction(error, gains)).rotated(-actual.theta());
    double turn = gains.heading() * Angles.difference(actual.theta(), place.theta());
    return new Twist(
        wanted.x(),
        wanted.y(),
        placeTwist.w() + Math.clamp(turn, -gains.mostTurnRate(), gains.mostTurnRate()));
  }

  /** The velocity that takes an error away, in the error's frame. */
  static Vec2 correction(Vec2 error, Gains gains) {
    Vec2 velocity = error.times(gains.place());
    double norm = velocity.norm();
    return norm <= gains.mostSpeed() ? velocity : velocity.times(gains.mostSpeed() / norm);
  }
}
