package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.dispatch.ControlMessage;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.ManualAnswer;
import org.toqa.fleet.ManualOrder;
import org.toqa.fleet.OperatorHold;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.PairingOrder;
import org.toqa.fleet.PathAnswer;
import org.toqa.fleet.PathQuestion;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskPreview;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.dispatch.DeliveryForecast.Delivery;
import org.toqa.fleet.floor.FloorEvent;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.trust.Fingerprint;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;

/** What the dispatch agent is told: by users, by its floor, by its store, by the clock. */
public sealed interface DispatchMessage {

  /**
   * @param deadline of {@link TaskSubmitter#deadline}
   */
  record SubmitTask(
      TaskOrder order,
      Orderer by,
      UUID idempotencyKey,
      long deadline,
      OrderChecks.Check check,
      ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements DispatchMessage {}

  /**
   * @param parts which part of an order each is, null where it is ordered by itself; empty: each is
   * @param deadline of {@link TaskSubmitter#deadline}
   */
  record SubmitTasks(
      List<TaskOrder> orders,
      List<@Nullable OrderPart> parts,
      Orderer by,
      List<UUID> idempotencyKeys,
      long deadline,
      OrderChecks.Check check,
      ActorRef<StatusReply<BatchAnswer>> replyTo)
      implements DispatchMessage {}

  record CheckOrders(
      List<TaskOrder> orders,
      String user,
      OrderChecks.Check check,
      ActorRef<StatusReply<BatchValidation.Result>> replyTo)
      implements DispatchMessage {}

  /**
   * A submitted order has been checked.
   *
   * @param checked null where the check failed, for the reason in {@code failure}
   */
  record OrderChecked(
      PendingOrders.Pending order,
      @Nullable Answer<TransportTask> checked,
      @Nullable Throwable failure)
      implements DispatchMessage {}

  /** Orders that were submitted together have been checked. */
  record OrdersChecked(SubmitTasks request, BatchValidation.Result checked)
      implements DispatchMessage {}

  /** The order of a preview is good. */
  record PreviewOrderChecked(TransportTask task, PreviewTask request) implements DispatchMessage {}

  record TasksStored(List<TransportTask> tasks, ActorRef<StatusReply<BatchAnswer>> replyTo)
      implements DispatchMessage {}

  record PreviewTask(
      TaskOrder order,
      String user,
      OrderChecks.Check check,
      ActorRef<StatusReply<Answer<TaskPreview>>> replyTo)
      implements DispatchMessage {}

  record FindPath(
      PathQuestion question,
      OrderChecks.Check check,
      ActorRef<StatusReply<Answer<PathAnswer>>> replyTo)
      implements DispatchMessage {}

  record TaskStored(TransportTask task, ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements DispatchMessage {}

  /**
   * @param notAdded called once it is known that the robot is not stored, by any thread
   */
  record AddRobot(
      RobotOrder order,
      String user,
      Runnable notAdded,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  record RobotStored(RobotRecord robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  /** A robot was not added after all. */
  record RobotNotStored(String robot) implements DispatchMessage {}

  /**
   * A robot was not changed, since it is another one in the store, or the store was away.
   *
   * @param stored null: it is not there
   */
  record RobotReread(String robot, @Nullable RobotRecord stored) implements DispatchMessage {}

  /**
   * A robot has shown its certificate.
   *
   * @param before the robot when that began
   */
  record RobotPaired(PairRobot request, RobotRecord before, Fingerprint fingerprint)
      implements DispatchMessage {}

  record PairRobot(
      String robot,
      PairingOrder order,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  /**
   * @param seen what the user has seen of the robot; null: whatever it is
   */
  record ChangeRobot(
      String robot,
      RobotChange change,
      @Nullable RobotChange seen,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  /**
   * @param move to where; null: it is gone
   */
  record RemoveRobot(
      String robot,
      @Nullable RobotMove move,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  /** A robot has been moved here, out of service, and that is safe. */
  record TakeRobot(RobotRecord robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  /**
   * What is stored of a robot that has been moved here.
   *
   * @param stored null: there is none any more
   */
  record RobotTaken(TakeRobot request, @Nullable StoredRobot stored) implements DispatchMessage {}

  /** What a robot has become is safe: it is paired, or has another address or strength. */
  record RobotChanged(RobotRecord robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  record LocateRobot(
      String robot, Pose pose, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  record SetInService(
      String robot,
      boolean inService,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  /** An operator command to a task. */
  record CommandTask(
      long task,
      MissionEvent.OperatorCommand command,
      ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements DispatchMessage {}

  /**
   * @param seen what the user has seen of the task; null: whatever it is
   */
  record EditTask(
      long task,
      TaskOrder order,
      @Nullable TransportTask seen,
      String user,
      OrderChecks.Check check,
      ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements DispatchMessage {}

  /** What shall be ordered of a task instead is good. */
  record EditChecked(TransportTask order, EditTask request) implements DispatchMessage {}

  record DeleteTask(TaskView task, String user, ActorRef<StatusReply<Answer<TaskView>>> replyTo)
      implements DispatchMessage {}

  /** The store has deleted it. */
  record TaskDeleted(DeleteTask request) implements DispatchMessage {}

  /**
   * What a queued task has become is safe.
   *
   * @param view what it was then
   */
  record TaskCommandStored(CommandTask request, Mission mission, Instant at, TaskView view)
      implements DispatchMessage {}

  record HoldRobot(
      String robot, boolean hold, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  record ClearStops(
      String robot,
      Set<String> reasons,
      String user,
      ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  record SendHome(String robot, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  record SendTo(String robot, Vec2 place, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage {}

  /** A person who drives a robot by hand wants a step more. */
  record DriveByHand(
      String robot,
      ManualOrder order,
      String user,
      ActorRef<StatusReply<Answer<ManualAnswer>>> replyTo)
      implements DispatchMessage {}

  /** He drives it no longer. It overtakes what came before it. */
  record EndManualDrive(
      String robot, UUID lease, String user, ActorRef<StatusReply<Answer<RobotView>>> replyTo)
      implements DispatchMessage, ControlMessage {}

  /**
   * All floors are paused, or go on. It overtakes what came before it.
   *
   * @param pause null: they go on
   */
  record ApplyPause(@Nullable Hold pause) implements DispatchMessage, ControlMessage {}

  /** These boxes lie on the floor, instead of those before. */
  record BoxesSeen(List<BoxView> boxes) implements DispatchMessage {
    public BoxesSeen {
      boxes = List.copyOf(boxes);
    }
  }

  /** A person puts the floor's robots on hold, or lets them go on. It overtakes likewise. */
  record HoldFloor(boolean hold, String user, ActorRef<StatusReply<Answer<Optional<Hold>>>> replyTo)
      implements DispatchMessage, ControlMessage {}

  /** It comes before what is asked afterwards. */
  record FloorResumeEnded(OperatorHold.ResumeEnded ended)
      implements DispatchMessage, ControlMessage {}

  /**
   * A manager chooses who decides which robots carry what.
   *
   * @param allocator its word; empty: that of the configuration
   */
  record ChooseAllocator(
      Optional<String> allocator,
      String user,
      ActorRef<StatusReply<Answer<Optional<String>>>> replyTo)
      implements DispatchMessage {}

  /** That choice is safe. */
  record AllocatorStored(ChooseAllocator command) implements DispatchMessage {}

  /** What the floor tells. */
  record FromFloor(FloorEvent event) implements DispatchMessage {}

  /**
   * A round of allocation is over.
   *
   * @param teams by task: whether the robots that were chosen to carry it together have room
   */
  record AllocationDecided(DecidedRound round, Map<Long, TeamFinding> teams)
      implements DispatchMessage {}

  /**
   * The open deadlines have been looked at.
   *
   * @param earliest when tasks can be delivered, by task, where that can be said
   */
  record DeadlinesChecked(Map<Long, Delivery> earliest) implements DispatchMessage {}

  /**
   * The deadlines of tasks that have just come into the queue have been looked at.
   *
   * @param earliest when tasks can be delivered, by task, where that can be said
   * @param reply is given the tasks with what is known of their deadlines
   */
  record QueuedDeadlinesChecked(
      List<TaskView> tasks, Map<Long, Delivery> earliest, Consumer<List<TaskView>> reply)
      implements DispatchMessage {}

  /**
   * It was computed when tasks will be delivered.
   *
   * @param result null: that failed
   */
  record TasksForecast(TaskForecaster.@Nullable Result result) implements DispatchMessage {}

  /** The store has stopped or begun to answer. */
  record StoreHealthChanged(boolean available) implements DispatchMessage {}

  /**
   * Time has gone on.
   *
   * @param latest takes the time of the latest tick; to be asked once
   */
  record Tick(Supplier<Instant> latest) implements DispatchMessage {}
}
