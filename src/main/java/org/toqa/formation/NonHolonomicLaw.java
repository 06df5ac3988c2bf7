package org.toqa.formation;

import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * The law for robots that cannot go sideways: the robot faces the direction in which it should go,
 * and goes as fast as that and the error ask for (Tanta, "Formation control", with the wanted place
 * turned by the leader's heading, a gain in place of the dead-beat 1/dt, and the place's own
 * velocity fed forward). It takes no heading from the place: on a curve each robot faces along its
 * own arc.
 */
public record NonHolonomicLaw(Gains gains) implements FollowerLaw {

  /** Below this speed, metres a second, a place counts as stopped. */
  private static final double STANDING_SPEED = 0.005;

  /** Metres; nearer than that a robot does not turn on the spot to come nearer still. */
  private static final double NEAR = 0.01;

  // u = q' + k (q - x),  v = |u| cos(e),  w = w_place + k_heading e,  e = angle from heading to u
  @Override
  public Twist velocity(Pose place, Twist placeTwist, Pose actual) {
    Vec2 feedForward = new Vec2(placeTwist.vx(), placeTwist.vy()).rotated(place.theta());
    Vec2 error = place.position().minus(actual.position());
    if (feedForward.norm() < STANDING_SPEED && error.norm() < NEAR) {
      return Twist.ZERO;
    }
    Vec2 wanted = feedForward.plus(SingleIntegratorLaw.correction(error, gains));
    double turn = Angles.difference(actual.theta(), wanted.angle());
    double most = gains.mostTurnRate();
    return new Twist(
        wanted.norm() * Math.max(0, Math.cos(turn)),
        0,
        placeTwist.w() + Math.clamp(gains.heading() * turn, -most, most));
  }
}
