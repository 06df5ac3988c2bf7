package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.wording.Sentence;

/**
 * What a floor agent is told: by the manager, by its robots' agents, by its store, by the clock.
 */
sealed interface FloorMessage {

  /** These robots shall carry out this task. */
  record Begin(Mission mission, List<String> robots, Sentence why) implements FloorMessage {}

  /**
   * Tasks whose loads are not picked up go to other robots: all of these moves, or none where one
   * cannot be any more.
   */
  record Exchange(List<Move> moves) implements FloorMessage {}

  record Move(long task, String from, String to, Sentence why) {}

  /** A person wants something of a task. */
  record Wished(long task, MissionEvent.Wish wish, ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements FloorMessage {}

  /**
   * All robots hold, or go on.
   *
   * @param pause null: they go on
   */
  record Pause(@Nullable Hold pause) implements FloorMessage {}

  /**
   * The floor's robots hold, or go on.
   *
   * @param hold null: they go on
   */
  record HoldFloor(@Nullable Hold hold) implements FloorMessage {}

  /** A person puts a robot on hold, or lets it go on. */
  record HoldRobot(
      String robot, boolean hold, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /** A person sends an idle robot to its parking point. */
  record SendHome(String robot, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  record RobotJoined(RobotRecord robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /** A person removes a robot. */
  record RemoveRobot(String robot, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /** That it is removed is safe: now let it have its effect. */
  record RobotRemoved(RemoveRobot wish) implements FloorMessage {}

  /** A robot has another certificate, address, strength or parking point. */
  record RobotChanged(RobotRecord robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  record Locate(
      String robot, Pose pose, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /** A person takes a robot out of service, or puts it back in. */
  record Serve(
      String robot,
      boolean inService,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /**
   * That is safe: now let it have its effect.
   *
   * @param clears whether it was said of a robot that kept its cells though it was not heard of
   */
  record ServiceStored(Serve wish, boolean clears) implements FloorMessage {}

  /** The mission's new state is safe: now do what follows from it. */
  record Stored(Mission.Step step) implements FloorMessage {}

  /** These robots are free, but what they have left lasts for no task that waits. */
  record Recharge(List<String> robots, long task) implements FloorMessage {}

  /**
   * That is safe: now the robot may move for it.
   *
   * @param turn null: it charges no more
   */
  record ChargeStored(String robot, ChargeRecord.@Nullable Turn turn) implements FloorMessage {}

  record Tick(Instant now) implements FloorMessage {}

  /** A robot's agent speaks. */
  sealed interface FromRobot extends FloorMessage {
    String robot();
  }

  /**
   * @param drive the last drive that was stored for it
   */
  record Connected(String robot, Hello hello, Optional<StoredDrive> drive) implements FromRobot {}

  record Disconnected(String robot, String why) implements FromRobot {}

  /** It is not connected, for one end does not trust the other. */
  record LinkRefused(String robot, Sentence why) implements FromRobot {}

  record Silent(String robot, Instant since) implements FromRobot {}

  record HeardAgain(String robot) implements FromRobot {}

  record Heard(String robot, AgentMessage.State state) implements FromRobot {}

  record PhaseEnded(String robot, PhaseEnd end) implements FromRobot {}

  /** The robot is being sent this drive. */
  record DriveBegun(String robot, StoredDrive drive) implements FromRobot {}

  /** The robot has taken this drive: what it says from now on, it says with it or after it. */
  record DriveTaken(String robot, long drive) implements FromRobot {}

  /**
   * @param changing the drive that the refused command was to change, if it was such a one
   */
  record Rejected(String robot, @Nullable Long changing, String reason) implements FromRobot {}
}
