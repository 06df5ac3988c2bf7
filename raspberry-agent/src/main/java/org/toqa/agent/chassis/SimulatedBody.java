package org.toqa.agent.chassis;

import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/**
 * The physical state of a simulated body at one instant.
 *
 * @param powerCycle counts power-ups, from 1
 * @param start where it was first put, map frame
 * @param truth where it really is, map frame
 * @param turned radians that each wheel has turned since power-up
 * @param rates of the wheels, radians a second
 * @param odometry what its encoders make of it, since power-up
 * @param command the last velocity wanted, robot frame
 * @param battery 0 to 1
 * @param steps simulated so far
 */
record SimulatedBody(
    long powerCycle,
    Pose start,
    Pose truth,
    ThreeWheels turned,
    ThreeWheels rates,
    Pose odometry,
    Twist command,
    double battery,
    long steps) {

  static final Pose ORIGIN = new Pose(0, 0, 0);

  static SimulatedBody placed(Pose start, double battery) {
    return new SimulatedBody(
        1, start, start, ThreeWheels.ZERO, ThreeWheels.ZERO, ORIGIN, Twist.ZERO, battery, 0);
  }

  SimulatedBody commanded(Twist wanted) {
    return new SimulatedBody(
        powerCycle, start, truth, turned, rates, odometry, wanted, battery, steps);
  }

  /** The same, but it takes itself to have moved so far since power-up. */
  SimulatedBody corrected(Pose moved) {
    return new SimulatedBody(
        powerCycle, start, truth, turned, rates, moved, command, battery, steps);
  }

  /** Switched off and on again where it is: it stands, and its odometry starts anew. */
  SimulatedBody powerCycled() {
    return new SimulatedBody(
        powerCycle + 1,
        start,
        truth,
        ThreeWheels.ZERO,
        ThreeWheels.ZERO,
        ORIGIN,
        Twist.ZERO,
        battery,
        steps);
  }
}
