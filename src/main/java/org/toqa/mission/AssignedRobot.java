package org.toqa.mission;

/**
 * A robot's part in a mission.
 *
 * @param phase the one that it is in
 * @param arrived whether it has ended that phase
 * @param unassigned whether it works for this mission no longer: parked, failed, or on another task
 */
public record AssignedRobot(String robot, Phase phase, boolean arrived, boolean unassigned) {

  static AssignedRobot of(String robot) {
    return new AssignedRobot(robot, Phase.TO_OBJECT, false, false);
  }

  AssignedRobot withArrived() {
    return new AssignedRobot(robot, phase, true, unassigned);
  }

  AssignedRobot withPhase(Phase next) {
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
