package org.toqa.fleet.dispatch;

import static java.util.Objects.requireNonNull;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReference;
import org.apache.pekko.actor.typed.ActorSystem;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.ManualAnswer;
import org.toqa.fleet.ManualOrder;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.PairingOrder;
import org.toqa.fleet.PathAnswer;
import org.toqa.fleet.PathQuestion;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotMessageKind;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskPreview;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.robot.AgentHealth;
import org.toqa.fleet.robot.RobotAgents;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/**
 * One floor as a system of agents: its dispatch, the floor's own, one a robot. Other floors have
 * others, which share nothing with these but the store and the threads. Any thread may call it; its
 * commands are those of {@link org.toqa.fleet.Fleet}.
 *
 * <p>It reads no clock for its decisions: whoever started it calls {@link #tick} about ten times a
 * second, with real or with simulated time.
 */
public final class FloorFleet implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(FloorFleet.class);
  private static final int CLOSE_SECONDS = 10;

  private final FloorMap floor;
  private final SharedParts shared;
  private final ActorSystem<DispatchMessage> system;
  private final DispatchCalls dispatch;
  private final AgentHealth health;
  private final RobotAgents robotAgents;
  private final CompletableFuture<Void> failed = new CompletableFuture<>();
  private volatile boolean isClosing;

  /** The time of a tick that the dispatch has not taken; a later one takes its place. */
  private final AtomicReference<@Nullable Instant> dueTick = new AtomicReference<>();

  /**
   * Reads the store and goes on with what is in it of this floor, when all agents have started.
   *
   * @param latest where its snapshots are published
   * @param pause of all floors, as it is now
   * @param now of the time that {@link #tick} brings
   * @throws IllegalStateException an agent cannot start; the message says which one and why
   */
  public FloorFleet(
      FloorMap floor,
      SharedParts shared,
      LatestSnapshot latest,
      @Nullable Hold pause,
      Instant now) {
    this.floor = floor;
    this.shared = shared;
    this.system =
        ActorSystem.create(
            DispatchAgent.of(floor, shared, latest, pause, now),
            "floor",
            AgentSystemSetup.of(shared.runtime()));
    this.dispatch = new DispatchCalls(system, shared.checks());
    this.health = AgentHealth.of(system);
    this.robotAgents = RobotAgents.of(system);
    awaitStart();
    var _ = system.getWhenTerminated().whenComplete((done, failure) -> ended());
    var _ = health.broken().thenRun(this::ended);
  }

  private void awaitStart() {
    try {
      CompletableFuture.anyOf(
              health.started().toCompletableFuture(),
              system.getWhenTerminated().toCompletableFuture())
          .join();
      health.started().toCompletableFuture().getNow(null);
    } catch (CompletionException e) {
      close();
      throw e.getCause() instanceof IllegalStateException refusal
          ? refusal
          : new IllegalStateException(
              "The floor " + floor.name() + " cannot start: " + e.getMessage(), e);
    }
  }

  private void ended() {
    if (!isClosing && failed.complete(null)) {
      log.error("{}: the agents have ended; the floor cannot go on.", floor.name());
    }
  }

  public FloorMap floor() {
    return floor;
  }

  /** Why the floor cannot go on by itself; empty while it can. */
  public List<Sentence> failures() {
    return health.failures(shared.runtime().monotonicNanos());
  }

  /** What people should know, though the floor goes on. */
  public List<Sentence> warnings() {
    return health.warnings(shared.runtime().monotonicNanos());
  }

  /** Completes when the agents have ended though nobody closed them: nothing moves any more. */
  public CompletionStage<Void> whenFailed() {
    return failed;
  }

  /** How many messages of robots were left out, by their kind, since the start. */
  public long passedOver(RobotMessageKind kind) {
    return health.passedOver(kind);
  }

  /** Time goes on: timers fire, robots are pinged, waiting tasks are looked at. */
  public void tick(Instant now) {
    health.recordTick(shared.runtime().monotonicNanos());
    robotAgents.tick(now);
    if (dueTick.getAndSet(now) == null) {
      system.tell(new DispatchMessage.Tick(() -> requireNonNull(dueTick.getAndSet(null))));
    }
  }

  /** By that time the floor has done what was due, but for its last tick. */
  public Instant floorTime() {
    return health.floorTime();
  }

  /** A robot's sensors beside its link see this; nothing where the robot is on another floor. */
  public void tellRanges(String robot, List<Double> ranges, List<Double> angles) {
    robotAgents.tell(robot, new RobotMessage.RangesHeard(ranges, angles));
  }

  /** These boxes lie on the floor, instead of those before. */
  public void tellBoxes(List<BoxView> boxes) {
    system.tell(new DispatchMessage.BoxesSeen(boxes));
  }

  /** All floors are paused, or go on where it is null. */
  public void applyPause(@Nullable Hold pause) {
    system.tell(new DispatchMessage.ApplyPause(pause));
  }

  /** The store has stopped or begun to answer. */
  public void tellStoreHealth(boolean available) {
    system.tell(new DispatchMessage.StoreHealthChanged(available));
  }

  /** Tasks were stored of orders that {@link #check} accepted. */
  public CompletionStage<BatchAnswer> takeTasks(List<TransportTask> tasks) {
    return dispatch.ask(replyTo -> new DispatchMessage.TasksStored(tasks, replyTo));
  }

  /** The tasks of these orders, none of which is stored, or what is said against them. */
  public CompletionStage<BatchValidation.Result> check(List<TaskOrder> orders, String user) {
    return dispatch.askChecked(
        user, (check, replyTo) -> new DispatchMessage.CheckOrders(orders, user, check, replyTo));
  }

  public CompletionStage<Answer<TaskView>> submit(TaskOrder order, Orderer by, UUID key) {
    long deadline = TaskSubmitter.deadline(shared.runtime().nanoTime());
    return dispatch.askChecked(
        by.name(),
        (check, replyTo) ->
            new DispatchMessage.SubmitTask(order, by, key, deadline, check, replyTo));
  }

  public CompletionStage<BatchAnswer> submitAll(
      List<TaskOrder> orders, List<@Nullable OrderPart> parts, Orderer by, List<UUID> keys) {
    long deadline = TaskSubmitter.deadline(shared.runtime().nanoTime());
    return dispatch.askChecked(
        by.name(),
        (check, replyTo) ->
            new DispatchMessage.SubmitTasks(orders, parts, by, keys, deadline, check, replyTo));
  }

  public CompletionStage<List<BatchAnswer.Rejection>> rejections(
      List<TaskOrder> orders, String user) {
    return check(orders, user).thenApply(BatchValidation.Result::rejections);
  }

  public CompletionStage<Answer<TaskPreview>> preview(TaskOrder order, String user) {
    return dispatch.askChecked(
        user, (check, replyTo) -> new DispatchMessage.PreviewTask(order, user, check, replyTo));
  }

  public CompletionStage<Answer<PathAnswer>> path(PathQuestion question, String user) {
    return dispatch.askChecked(
        user, (check, replyTo) -> new DispatchMessage.FindPath(question, check, replyTo));
  }

  /**
   * @param notAdded called, by any thread, once it is known that the robot is not stored; that may
   *     be later than the answer, which does not wait for ever
   */
  public CompletionStage<Answer<RobotView>> addRobot(
      RobotOrder order, String user, Runnable notAdded) {
    return dispatch.ask(replyTo -> new DispatchMessage.AddRobot(order, user, notAdded, replyTo));
  }

  public CompletionStage<Answer<RobotView>> pairRobot(
      String robot, PairingOrder order, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.PairRobot(robot, order, user, replyTo));
  }

  public CompletionStage<Answer<RobotView>> changeRobot(
      String robot, RobotChange change, @Nullable RobotChange seen, String user) {
    return dispatch.ask(
        replyTo -> new DispatchMessage.ChangeRobot(robot, change, seen, user, replyTo));
  }

  public CompletionStage<Answer<RobotView>> removeRobot(String robot, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.RemoveRobot(robot, null, user, replyTo));
  }

  /** It is here no more, and on the other floor from the next start on. */
  public CompletionStage<Answer<RobotView>> giveRobot(String robot, RobotMove move, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.RemoveRobot(robot, move, user, replyTo));
  }

  /** It was given to this floor, out of service. */
  public CompletionStage<Answer<RobotView>> takeRobot(RobotRecord robot) {
    return dispatch.ask(replyTo -> new DispatchMessage.TakeRobot(robot, replyTo));
  }

  public CompletionStage<Answer<RobotView>> locateRobot(String robot, Pose pose, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.LocateRobot(robot, pose, user, replyTo));
  }

  public CompletionStage<Answer<RobotView>> setInService(
      String robot, boolean inService, String user) {
    return dispatch.ask(
        replyTo -> new DispatchMessage.SetInService(robot, inService, user, replyTo));
  }

  public CompletionStage<Answer<RobotView>> holdRobot(String robot, boolean hold, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.HoldRobot(robot, hold, user, replyTo));
  }

  public CompletionStage<Answer<RobotView>> clearStops(
      String robot, Set<String> reasons, String user) {
    return dispatch.ask(
        replyTo -> new DispatchMessage.ClearStops(robot, Set.copyOf(reasons), user, replyTo));
  }

  public CompletionStage<Answer<RobotView>> sendHome(String robot, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.SendHome(robot, user, replyTo));
  }

  public CompletionStage<Answer<RobotView>> sendTo(String robot, Vec2 place) {
    return dispatch.ask(replyTo -> new DispatchMessage.SendTo(robot, place, replyTo));
  }

  public CompletionStage<Answer<ManualAnswer>> driveByHand(
      String robot, ManualOrder order, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.DriveByHand(robot, order, user, replyTo));
  }

  public CompletionStage<Answer<RobotView>> endManualDrive(String robot, UUID lease, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.EndManualDrive(robot, lease, user, replyTo));
  }

  public CompletionStage<Answer<TaskView>> commandTask(
      long task, MissionEvent.OperatorCommand command) {
    return dispatch.ask(replyTo -> new DispatchMessage.CommandTask(task, command, replyTo));
  }

  public CompletionStage<Answer<TaskView>> editTask(
      long task, TaskOrder order, @Nullable TransportTask seen, String user) {
    return dispatch.askChecked(
        user,
        (check, replyTo) -> new DispatchMessage.EditTask(task, order, seen, user, check, replyTo));
  }

  public CompletionStage<Answer<TaskView>> deleteTask(TaskView task, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.DeleteTask(task, user, replyTo));
  }

  public CompletionStage<Answer<Optional<Hold>>> hold(boolean hold, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.HoldFloor(hold, user, replyTo));
  }

  public CompletionStage<Answer<Optional<String>>> chooseAllocator(
      Optional<String> allocator, String user) {
    return dispatch.ask(replyTo -> new DispatchMessage.ChooseAllocator(allocator, user, replyTo));
  }

  /** Ends the agents: links are closed, what was handed to the store is written. */
  @Override
  public void close() {
    isClosing = true;
    system.terminate();
    try {
      system.getWhenTerminated().toCompletableFuture().get(CLOSE_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (TimeoutException | ExecutionException e) {
      log.warn("{}: the agents did not end in time.", floor.name(), e);
    }
  }
}
