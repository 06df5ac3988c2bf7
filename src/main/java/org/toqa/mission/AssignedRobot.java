package org.toqa.mission;

/**
 * A robot's part in a mission.
 *
 * @param phase 1 to the object, 2 to the goal, 3 home
 * @param arrived whether it has ended that phase
 * @param unassigned whether it works for this mission no longer: parked, failed, or on another task
 */
public record AssignedRobot(String robot, int phase, boolean arrived, boolean unassigned) {

  static AssignedRobot of(String robot) {
    return new AssignedRobot(robot, 1, false, false);
  }

  AssignedRobot withArrived() {
    return new AssignedRobot(robot, phase, true, unassigned);
  }

  AssignedRobot withPhase(int next) {
    return new AssignedRobot(robot, next, false, unassigned);
  }

  AssignedRobot withUnassigned() {
    return new AssignedRobot(robot, phase, arrived, true);
  }

  /** Whether the mission still waits for this robot to drive the phase to its end. */
  public boolean isDriving() {
    return !arrived && !unassigned;
  }
}
