package org.toqa.mission;

/** What a mission wants done, once its new state is stored. */
public sealed interface MissionCommand {

  String robot();

  /** Let the robot drive the phase. */
  record Drive(String robot, Phase phase) implements MissionCommand {}

  /** Let the robot stop where it is, and set the load down. */
  record Stop(String robot) implements MissionCommand {}

  /** The robot is free: parked, failed, or on another task. */
  record Unassign(String robot) implements MissionCommand {}
}
