package org.toqa.fleet;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
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

  /** Metres a second. */
  double maxSpeed = ScriptedRobot.MAX_SPEED;

  /** Radians a second. */
  double maxTurnRate = ScriptedRobot.MAX_TURN_RATE;

  int stepsPerSegment = 1;
  boolean mute;
  boolean stuck;
  boolean endsBeforeNextChange;
  boolean refusesClear;
  int lostClears;
  @Nullable Fault fault;

  boolean canDrive(Segment segment) {
    return segment.v() <= maxSpeed + 1e-9 && Math.abs(segment.w()) <= maxTurnRate + 1e-9;
  }
}
