package org.toqa.fleet.floor;

import java.util.List;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.wording.Sentence;

/** What a floor's agent tells the manager. */
public sealed interface FloorEvent {
  /** The floor has the robot, and its report before this tells of it. */
  record RobotJoined(RobotView robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorEvent {}

  /** The floor has the robot no more, and its report before this does not tell of it. */
  record RobotRemoved(RobotView robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements FloorEvent {}

  /** A robot failed before it had the load: the task goes back to the queue, and that is safe. */
  record TaskReturned(Mission mission) implements FloorEvent {}

  /** The floor has the task; its reports from now on tell of it. */
  record TaskBegun(long task) implements FloorEvent {}

  /** A robot of the task's was taken meanwhile: it goes back to its place in the queue. */
  record TaskNotBegun(Mission mission) implements FloorEvent {}

  /**
   * @param floor the obstacles on it
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
      implements FloorEvent {}

  /** The floor has done what its tick asked for; a report of it, if any, came before. */
  record Ticked() implements FloorEvent {}

  /** The floor has no such task: perhaps it is in the queue by now. */
  record TaskUnknown(
      long task,
      MissionEvent.OperatorCommand command,
      ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements FloorEvent {}
}
