package org.toqa.mission;

/**
 * A robot's part in a mission.
 *
 * @param phase 1 to the object, 2 to the goal, 3 home
 * @param arrived whether it has ended that phase
 * @param released whether it works for this mission no longer: parked, failed, or on another task
 */
public record Carrier(String robot, int phase, boolean arrived, boolean released) {

  static Carrier chosen(String robot) {
    return new Carrier(robot, 1, false, false);
  }

  Carrier arrivedAtEnd() {
    return new Carrier(robot, phase, true, released);
  }

  Carrier inPhase(int next) {
    return new Carrier(robot, next, false, released);
  }

  Carrier letGo() {
    return new Carrier(robot, phase, arrived, true);
  }

  /** Whether the mission still waits for this robot to drive the phase to its end. */
  public boolean isDriving() {
    return !arrived && !released;
  }
}
