package org.toqa.mission;

/** What can happen to a mission. An event that is repeated or comes too late changes nothing. */
public sealed interface MissionEvent {

  String robot();

  /** The robot was sent its way for the phase. */
  record DriveStarted(String robot, int phase) implements MissionEvent {}

  /** The robot has driven the phase to its end. */
  record PhaseEnded(String robot, int phase) implements MissionEvent {}

  /** The robot, on its way home, was given another task. */
  record Retasked(String robot) implements MissionEvent {}
}
