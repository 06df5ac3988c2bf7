package org.toqa.formation;

import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/** How a robot is steered after a place that moves. */
public sealed interface FollowerLaw permits SingleIntegratorLaw, NonHolonomicLaw, UnicycleLaw {

  /**
   * The velocity that leads to the place.
   *
   * @param place where the robot should be, map frame
   * @param placeTwist how that place moves, in its own frame
   * @param actual where the robot is, map frame
   * @return the velocity to command, in the robot's frame
   */
  Twist velocity(Pose place, Twist placeTwist, Pose actual);
}
