package org.toqa.arm;

/**
 * Brings the joints of an arm to where they shall be, by trajectories: whatever is wanted anew, and
 * a halt, is obeyed by slowing down on the way first. For one thread.
 */
final class JointMotion {

  private final Arm arm;
  private JointTrajectory trajectory;
  private double seconds;
  private JointAngles goal;
  private boolean braking;

  /**
   * @param at how they stand
   */
  JointMotion(Arm arm, JointAngles at) {
    this.arm = arm;
    this.trajectory = JointTrajectory.standing(at);
    this.goal = at;
  }

  /** They shall stand where they do, at once. */
  void stand(JointAngles at) {
    trajectory = JointTrajectory.standing(at);
    seconds = 0;
    goal = at;
    braking = false;
  }

  void setGoal(JointAngles angles) {
    goal = angles;
  }

  /**
   * @param passed seconds since the last call
   * @param mayMove false: they come to a stand on their way
   * @param actual how they stand, from where they go on after a halt: what stopped them may have
   *     done so at once
   */
  void advance(double passed, boolean mayMove, JointAngles actual) {
    seconds += passed;
    boolean isOver = isOver();
    boolean isElsewhere = braking || !endsAtGoal();
    if (!isOver && !braking && (!mayMove || isElsewhere)) {
      trajectory = trajectory.brakedFrom(seconds);
      seconds = 0;
      braking = true;
    } else if (isOver && mayMove && isElsewhere) {
      trajectory = JointTrajectory.between(arm, standOf(actual), goal);
      seconds = 0;
      braking = false;
    }
  }

  private JointAngles standOf(JointAngles actual) {
    JointAngles end = trajectory.end();
    return actual.minus(end).largest() > ArmControl.TOLERANCE ? actual : end;
  }

  JointAngles goal() {
    return goal;
  }

  /** As far as sums of fractions tell. */
  private boolean endsAtGoal() {
    return trajectory.end().minus(goal).largest() < JointLimits.SAME_ANGLE;
  }

  private boolean isOver() {
    return seconds >= trajectory.duration();
  }

  /** Whether they stand where they shall be. */
  boolean isAtGoal() {
    return !braking && isOver() && endsAtGoal();
  }

  /** Whether they stand. */
  boolean isStanding() {
    return isOver();
  }

  JointTrajectory.Moment now() {
    return trajectory.at(seconds);
  }
}
