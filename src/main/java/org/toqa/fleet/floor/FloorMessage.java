package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.dispatch.ControlMessage;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.ManualAnswer;
import org.toqa.fleet.ManualOrder;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.robot.RobotEvent;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Sentence;

/**
 * What a floor agent is told: by the manager, by its robots' agents, by its store, by the clock.
 */
public sealed interface FloorMessage {

  /** These robots shall carry out this task. */
  record BeginTask(Mission mission, List<String> robots, Sentence why) implements FloorMessage {}

  /**
   * Tasks whose loads are not picked up go to other robots: all of these moves, or none where one
   * cannot be any more.
   */
  record ExchangeTasks(List<Move> moves) implements FloorMessage {}

  record Move(long task, String from, String to, Sentence why) {}

  /** The mission, which has ended without robots, has left its load on the floor. */
  record LoadLeft(Mission mission, Instant endedAt) implements FloorMessage {}

  /** A person wants something of a task. */
  record CommandTask(
      long task,
      MissionEvent.OperatorCommand command,
      ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements FloorMessage {}

  /**
   * All robots hold, or go on.
   *
   * @param pause null: they go on
   */
  record SetPause(@Nullable Hold pause) implements FloorMessage, ControlMessage {}

  /**
   * The floor's robots hold, or go on.
   *
   * @param hold null: they go on
   */
  record HoldFloor(@Nullable Hold hold) implements FloorMessage, ControlMessage {}

  /** A person puts a robot on hold, or lets it go on. */
  record HoldRobot(
      String robot, boolean hold, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /**
   * That the robot may go on is safe.
   *
   * @param resume number of the resume
   */
  record ResumeStored(HoldRobot command, long resume) implements FloorMessage {}

  /**
   * That the robot may go on can never be stored.
   *
   * @param resume number of the resume
   */
  record ResumeNotStored(HoldRobot command, long resume, StoreException refusal)
      implements FloorMessage {}

  /**
   * A person clears the stops of a robot's hardware.
   *
   * @param reasons the codes of the faults that the person was shown
   */
  record ClearStops(
      String robot,
      Set<String> reasons,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /** That a person has said so is safe: now the robot may be told. */
  record ClearStored(ClearStops command) implements FloorMessage {}

  /** These boxes lie on the floor, instead of those before. */
  record BoxesSeen(List<BoxView> boxes) implements FloorMessage {
    public BoxesSeen {
      boxes = List.copyOf(boxes);
    }
  }

  /** A person sends an idle robot to its parking point. */
  record SendHome(String robot, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /** A robot that has nothing to do shall drive to a place, metres, map frame. */
  record SendTo(String robot, Vec2 place, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /** A person who drives a robot by hand wants a step more. */
  record DriveByHand(
      String robot,
      ManualOrder order,
      String user,
      ActorRef<StatusReply<Answer<ManualAnswer>>> replyTo)
      implements FloorMessage {}

  /** He drives it no longer. */
  record EndManualDrive(
      String robot, UUID lease, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage, ControlMessage {}

  /** A robot was added, or moved here from another floor. */
  record AddRobot(StoredRobot robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /**
   * A person removes a robot.
   *
   * @param move to where; null: it is gone
   */
  record RemoveRobot(
      String robot,
      @Nullable RobotMove move,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /** That it is removed is safe: now let it have its effect. */
  record RobotRemoved(RemoveRobot command) implements FloorMessage {}

  /** A robot has another certificate, address, strength or parking point. */
  record RobotChanged(RobotRecord robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  record LocateRobot(
      String robot, Pose pose, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /** A person takes a robot out of service, or puts it back in. */
  record SetInService(
      String robot,
      boolean inService,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorMessage {}

  /**
   * That is safe: now let it have its effect.
   *
   * @param freesCells whether it was said of a robot that kept its cells though it was not heard of
   */
  record ServiceStored(SetInService command, boolean freesCells) implements FloorMessage {}

  /** The mission's new state is safe: now do what follows from it. */
  record StepStored(Mission.Step step) implements FloorMessage {}

  /** These robots are free, but what they have left lasts for no task that waits. */
  record RechargeRobots(List<String> robots, long task) implements FloorMessage {}

  /**
   * That is safe: now the robot may move for it.
   *
   * @param turn null: it charges no more
   */
  record ChargeStored(String robot, ChargeRecord.@Nullable Turn turn) implements FloorMessage {}

  record Tick(Instant now) implements FloorMessage {}

  /** What a robot's agent tells. */
  record FromRobot(RobotEvent event) implements FloorMessage {}
}
