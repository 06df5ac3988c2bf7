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

  void setGoal(JointAngles angles) {
    goal = angles;
  }

  /**
   * @param passed seconds since the last call
   * @param mayMove false: they come to a stand on their way
   */
  void advance(double passed, boolean mayMove) {
    seconds += passed;
    boolean isOver = isOver();
    boolean isElsewhere = braking || !trajectory.end().equals(goal);
    if (!isOver && !braking && (!mayMove || isElsewhere)) {
      trajectory = trajectory.brakedFrom(seconds);
      seconds = 0;
      braking = true;
    } else if (isOver && mayMove && isElsewhere) {
      trajectory = JointTrajectory.between(arm, trajectory.end(), goal);
      seconds = 0;
      braking = false;
    }
  }

  private boolean isOver() {
    return seconds >= trajectory.duration();
  }

  /** Whether they stand where they shall be. */
  boolean isAtGoal() {
    return !braking && isOver() && trajectory.end().equals(goal);
  }

  /** Whether they stand. */
  boolean isStanding() {
    return isOver();
  }

  JointTrajectory.Moment now() {
    return trajectory.at(seconds);
  }
}
