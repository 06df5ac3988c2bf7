package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.allocation.Decision;
import org.toqa.geometry.Pose;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/** What the manager agent is told: by users, by floors, by its store, by the clock. */
sealed interface ManagerMessage {

  record Submit(
      TaskOrder order, String user, UUID key, ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements ManagerMessage {}

  record SubmitAll(
      List<TaskOrder> orders,
      String user,
      List<UUID> keys,
      ActorRef<StatusReply<BatchAnswer>> replyTo)
      implements ManagerMessage {}

  record CheckAll(
      List<TaskOrder> orders, String user, ActorRef<StatusReply<List<BatchAnswer.Refusal>>> replyTo)
      implements ManagerMessage {}

  record AllStored(List<TransportTask> tasks, ActorRef<StatusReply<BatchAnswer>> replyTo)
      implements ManagerMessage {}

  record PreviewTask(
      TaskOrder order, String user, ActorRef<StatusReply<Answer<TaskPreview>>> replyTo)
      implements ManagerMessage {}

  record TaskStored(TransportTask task, ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements ManagerMessage {}

  record AddRobot(RobotOrder order, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  record RobotStored(RobotRecord robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  /** The floor has the robot, and its report before this tells of it. */
  record RobotJoined(RobotView robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  /** A robot was not added after all. */
  record RobotNotStored(String robot) implements ManagerMessage {}

  /** A robot stays as it was. */
  record RobotNotChanged(RobotRecord robot) implements ManagerMessage {}

  record PairRobot(
      String robot,
      PairingOrder order,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  record ChangeRobot(
      String robot,
      RobotChange change,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  record RemoveRobot(String robot, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  /** The floor has the robot no more, and its report before this does not tell of it. */
  record RobotRemoved(RobotView robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  /** What a robot has become is safe: it is paired, or has another address or strength. */
  record RobotChanged(RobotRecord robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  record Locate(
      String robot, Pose pose, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  record Serve(
      String robot,
      boolean inService,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  /** A person wants something of a task. */
  record Wished(long task, MissionEvent.Wish wish, ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements ManagerMessage {}

  /** What a queued task has become is safe. */
  record WishStored(Mission mission) implements ManagerMessage {}

  record HoldRobot(
      String robot, boolean hold, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  record SendHome(String robot, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  /** A person pauses all robots, or lets them go on. */
  record Pause(boolean pause, String user, ActorRef<StatusReply<Answer<Optional<Hold>>>> replyTo)
      implements ManagerMessage {}

  /** That they go on is safe. */
  record PauseEnded() implements ManagerMessage {}

  /** A person puts a floor's robots on hold, or lets them go on. */
  record HoldFloor(
      String floor,
      boolean hold,
      String user,
      ActorRef<StatusReply<Answer<Optional<Hold>>>> replyTo)
      implements ManagerMessage {}

  /** That the floor's robots go on is safe. */
  record FloorHoldEnded(String floor) implements ManagerMessage {}

  /** A robot failed before it had the load: the task goes back to the queue, and that is safe. */
  record Returned(Mission mission) implements ManagerMessage {}

  /** The floor has the task; its reports from now on tell of it. */
  record Begun(long task) implements ManagerMessage {}

  /** A robot of the task's was taken meanwhile: it goes back to its place in the queue. */
  record NotBegun(Mission mission) implements ManagerMessage {}

  /**
   * @param floor what is in the way on it
   * @param robots all robots of the floor
   * @param missions its tasks that have not ended
   * @param ended tasks that ended since the last report
   * @param alerts sentences that concern the whole floor
   */
  record FloorReport(
      FloorView floor,
      List<RobotView> robots,
      List<TaskView> missions,
      List<TaskView> ended,
      List<Sentence> alerts)
      implements ManagerMessage {}

  /** The floor has done what its tick asked for; a report of it, if any, came before. */
  record Ticked(String floor) implements ManagerMessage {}

  /**
   * A round of allocation is over.
   *
   * @param decisions none where it failed
   */
  record Decided(String floor, List<Decision> decisions) implements ManagerMessage {}

  /** The store has stopped or begun to answer. */
  record StoreWatched(boolean answers) implements ManagerMessage {}

  record Tick(Instant now) implements ManagerMessage {}
}
