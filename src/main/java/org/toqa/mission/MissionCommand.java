package org.toqa.mission;

/** What a mission wants done, once its new state is stored. */
public sealed interface MissionCommand {

  String robot();

  /** Send the robot its way for the phase: 1 to the object, 2 to the goal, 3 home. */
  record Drive(String robot, int phase) implements MissionCommand {}

  /** Let the robot come to a stand where it is, and set the load down. */
  record Stop(String robot) implements MissionCommand {}

  /** The robot is free: parked, failed, or on another task. */
  record Unassign(String robot) implements MissionCommand {}
}
