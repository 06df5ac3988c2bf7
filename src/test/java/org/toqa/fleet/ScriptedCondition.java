package org.toqa.fleet;

import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.RoomUse;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.motion.DriveKind;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;

/** What a test lets be so with a scripted robot, until it lets it be otherwise. */
final class ScriptedCondition {
  /** Metres, on the map. */
  List<Vec2> obstacles = List.of();

  /** Of 0 to 1. */
  double battery = 0.8;

  /** Metres across. */
  double footprint = ScriptedRobot.FOOTPRINT;

  /** Metres; it sees through all of a hall. */
  double sensorRange = 20;

  DriveKind kind = DriveKind.OMNI;

  /** Metres a second. */
  double maxLoad = ScriptedRobot.MAX_LOAD;

  double maxSpeed = ScriptedRobot.MAX_SPEED;

  /** Radians a second. */
  double maxTurnRate = ScriptedRobot.MAX_TURN_RATE;

  int stepsPerSegment = 1;
  boolean mute;

  /**
   * Whether it is out of the server's reach: it does what it was told, and other robots hear it.
   */
  boolean isOutOfReach;

  /** The pose that it reports while it does not know where it is; null: it knows. */
  @Nullable Pose odometry;

  boolean stuck;
  boolean endsBeforeNextChange;
  boolean refusesClear;

  /** What it answers with {@code reject}, beside what it cannot do. */
  Predicate<Command> refused = _ -> false;

  /** Whether it hears no command, but reports. */
  boolean deaf;

  /** Whether it is so over this connection only. */
  boolean hearsOverAnother;

  /** What is wrong with its states; null: nothing. */
  @Nullable String stateFault;

  /** Whether it does not hear that the formation which it follows has ended. */
  boolean missesEnd;

  /** It is told to follow, and does not. */
  boolean stays;

  /** Whether it needs room beside its path, or has it. */
  RoomUse roomUse = RoomUse.NONE;

  /** Null: it has none. */
  @Nullable PassingRoom room;

  boolean refusesRoom;

  /** Whether it finds its own way through free zones. */
  boolean freeZones;

  boolean hasRefusedRoom;

  int lostClears;
  @Nullable Fault fault;

  /** Whether it stands too far beside its path. */
  boolean offPath;

  boolean canDrive(Segment segment) {
    return segment.v() <= maxSpeed + 1e-9 && Math.abs(segment.w()) <= maxTurnRate + 1e-9;
  }

  boolean canMove() {
    return !stuck && !offPath && fault == null;
  }

  /**
   * What it says of that.
   *
   * @param groupStopReason null: it is in no group, or that drives
   */
  List<Fault> faults(@Nullable String groupStopReason) {
    if (fault != null) {
      return List.of(fault);
    }
    if (offPath) {
      return List.of(new Fault("OFF_WAY", "The robot is 0.20 m off its path; it stands."));
    }
    return groupStopReason == null
        ? List.of()
        : List.of(new Fault("FORMATION_STOPPED", groupStopReason));
  }
}
