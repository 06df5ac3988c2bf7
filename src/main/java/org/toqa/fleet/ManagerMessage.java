package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.allocation.Decision;
import org.toqa.geometry.Pose;
import org.toqa.mission.TransportTask;

/** What the manager agent is told: by users, by floors, by its store, by the clock. */
sealed interface ManagerMessage {

  record Submit(TaskOrder order, String user, ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements ManagerMessage {}

  record TaskStored(TransportTask task, ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements ManagerMessage {}

  record AddRobot(RobotOrder order, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  record RobotStored(RobotRecord robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  record RobotNotStored(String robot) implements ManagerMessage {}

  record Locate(
      String robot, Pose pose, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  record Serve(
      String robot,
      boolean inService,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements ManagerMessage {}

  /** The floor has the task; its reports from now on tell of it. */
  record Begun(long task) implements ManagerMessage {}

  /** A robot of the task's was taken meanwhile: it goes back to its place in the queue. */
  record NotBegun(TransportTask task) implements ManagerMessage {}

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
      List<String> alerts)
      implements ManagerMessage {}

  /**
   * A round of allocation is over.
   *
   * @param decisions none where it failed
   */
  record Decided(String floor, List<Decision> decisions) implements ManagerMessage {}

  record Tick(Instant now) implements ManagerMessage {}
}
