package org.toqa.agent.firmware;

import org.toqa.arm.JointAngles;

/**
 * What the microcontroller reports of its arm.
 *
 * @param angles of the joints, as measured
 * @param goal where it brings them
 * @param load kilograms on the hand
 * @param progress share of the way to its goal, 0 to 1; 1 only there
 */
record ArmStatus(
    State state,
    boolean handClosed,
    JointAngles angles,
    JointAngles goal,
    double load,
    double progress) {

  /** In the order of the codes. */
  enum State {
    /** There is none, or it was not measured yet. */
    UNKNOWN,
    STANDING,
    MOVING,
    /** Its joints did not follow, and stand. */
    STALLED
  }
}
