package org.toqa.agent.chassis;

import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.motion.WheelSpeeds;

/**
 * The physical state of a simulated body at one instant.
 *
 * @param powerCycle counts power-ups, from 1
 * @param start where it was first put, map frame
 * @param truePose where it really is, map frame
 * @param wheelTurns radians that each wheel has turned since power-up
 * @param odometry what its encoders make of it, since power-up
 * @param command the last velocity wanted, robot frame
 * @param battery 0 to 1
 * @param steps simulated so far, counted
 */
record SimulatedChassisState(
    long powerCycle,
    Pose start,
    Pose truePose,
    ThreeWheels wheelTurns,
    WheelSpeeds wheelSpeeds,
    Pose odometry,
    Twist command,
    double battery,
    long steps) {

  static final Pose ORIGIN = new Pose(0, 0, 0);

  static SimulatedChassisState atStart(Pose start, double battery) {
    return new SimulatedChassisState(
        1, start, start, ThreeWheels.ZERO, WheelSpeeds.ZERO, ORIGIN, Twist.ZERO, battery, 0);
  }

  SimulatedChassisState withCommand(Twist wanted) {
    return new SimulatedChassisState(
        powerCycle, start, truePose, wheelTurns, wheelSpeeds, odometry, wanted, battery, steps);
  }

  /**
   * The same a while later, in which it did not move.
   *
   * @param batteryNow 0 to 1
   * @param stepsMore how many steps later
   */
  SimulatedChassisState stopped(double batteryNow, long stepsMore) {
    return new SimulatedChassisState(
        powerCycle,
        start,
        truePose,
        wheelTurns,
        WheelSpeeds.ZERO,
        odometry,
        command,
        batteryNow,
        steps + stepsMore);
  }

  /** The same, but it takes itself to have moved so far since power-up. */
  SimulatedChassisState withOdometry(Pose moved) {
    return new SimulatedChassisState(
        powerCycle, start, truePose, wheelTurns, wheelSpeeds, moved, command, battery, steps);
  }

  /**
   * The same, put aside, which it knows.
   *
   * @param by metres, in the frame in which it began
   */
  SimulatedChassisState shoved(Vec2 by) {
    Vec2 really = truePose.position().plus(by.rotated(start.theta()));
    Vec2 moved = odometry.position().plus(by);
    return new SimulatedChassisState(
        powerCycle,
        start,
        new Pose(really.x(), really.y(), truePose.theta()),
        wheelTurns,
        wheelSpeeds,
        new Pose(moved.x(), moved.y(), odometry.theta()),
        command,
        battery,
        steps);
  }

  /**
   * The same, carried to another place, of which its wheels tell it nothing: where it began is now
   * from where it would have driven there.
   *
   * @param place map frame
   */
  SimulatedChassisState carriedTo(Pose place) {
    return new SimulatedChassisState(
        powerCycle,
        place.compose(odometry.relative(ORIGIN)),
        place,
        wheelTurns,
        wheelSpeeds,
        odometry,
        command,
        battery,
        steps);
  }

  /** Switched off and on again where it is: it is stopped, and its odometry starts anew. */
  SimulatedChassisState withPowerCycle() {
    return new SimulatedChassisState(
        powerCycle + 1,
        start,
        truePose,
        ThreeWheels.ZERO,
        WheelSpeeds.ZERO,
        ORIGIN,
        Twist.ZERO,
        battery,
        steps);
  }
}
