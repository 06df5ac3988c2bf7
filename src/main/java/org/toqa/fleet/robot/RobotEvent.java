package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.RobotMessageKind;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.ActEnd;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.wording.Sentence;

/** What a robot's agent tells its floor. */
public sealed interface RobotEvent {
  /** So long a robot that does not do what it is told is told nothing new. */
  Duration LEFT_OUT_FOR = Duration.ofMinutes(5);

  /** The name of the robot. */
  String robot();

  /**
   * @param drive the last drive that was stored for it
   */
  record Connected(String robot, Hello hello, Optional<StoredDrive> drive) implements RobotEvent {}

  record Disconnected(String robot, Sentence why) implements RobotEvent {}

  /** It is not connected, for one end does not trust the other. */
  record LinkRefused(String robot, Sentence why) implements RobotEvent {}

  /**
   * No state of it has come for a while.
   *
   * @param fault what is wrong with what has come instead; null: nothing
   */
  record FellSilent(String robot, Instant since, @Nullable String fault) implements RobotEvent {}

  record HeardAgain(String robot) implements RobotEvent {}

  record StateReported(String robot, AgentMessage.State state) implements RobotEvent {}

  record PhaseEnded(String robot, PhaseEnd end) implements RobotEvent {}

  /** What the arm was told has ended. */
  record Acted(String robot, ActEnd end) implements RobotEvent {}

  /** The robot is being sent this drive. */
  record DriveBegun(String robot, StoredDrive drive) implements RobotEvent {}

  /** The drive of that number was cancelled before the robot was sent it. */
  record DriveWithdrawn(String robot, long drive) implements RobotEvent {}

  /** The robot has taken this drive: what it says from now on, it says with it or after it. */
  record DriveAccepted(String robot, long drive) implements RobotEvent {}

  /**
   * The robot has taken the room that it was lent: what it says of it from now on, it says with it
   * or after it.
   */
  record RoomTaken(String robot) implements RobotEvent {}

  /** The robot has taken where it is: the place that it says from now on follows from that. */
  record Located(String robot) implements RobotEvent {}

  /** The robot has not taken the room that it was lent. */
  record RoomRefused(String robot) implements RobotEvent {}

  /** What a person cleared is not cleared. */
  record ClearRejected(String robot, Sentence why) implements RobotEvent {}

  /** It says so much of that kind that a part is left out. */
  record FloodBegan(String robot, RobotMessageKind kind) implements RobotEvent {}

  /** It says no more than it may again. */
  record FloodEnded(String robot) implements RobotEvent {}

  /**
   * @param changing the drive that the refused command was to change, if it was such a one
   * @param isDrive whether the robot itself has refused to begin a drive
   */
  record CommandRejected(String robot, @Nullable Long changing, String reason, boolean isDrive)
      implements RobotEvent {}

  /** It reports, but answers no commands, also over a connection that was made for that. */
  record NotAnswering(String robot) implements RobotEvent {}
}
