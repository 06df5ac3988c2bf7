package org.toqa.fleet.manager;

import static java.util.Objects.requireNonNull;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.apache.pekko.actor.typed.ActorSystem;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.allocation.AllocationMethod;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FloorEditing;
import org.toqa.fleet.Hold;
import org.toqa.fleet.PairingOrder;
import org.toqa.fleet.PathAnswer;
import org.toqa.fleet.PathQuestion;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotMessageKind;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.Schedules;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskPreview;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.robot.AgentHealth;
import org.toqa.fleet.robot.RobotAgents;
import org.toqa.fleet.schedule.StoredSchedules;
import org.toqa.geometry.Pose;
import org.toqa.grid.FloorMap;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.gateway.GatewayState;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The fleet as a system of agents: one manager, one agent a floor, one a robot.
 *
 * <p>It reads no clock for its decisions: whoever started it calls {@link #tick} about ten times a
 * second, with real or with simulated time.
 */
public final class AgentFleet implements Fleet, AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(AgentFleet.class);

  private final List<FloorMap> floors;
  private final LatestSnapshot latestSnapshot;
  private final RobotLinkFactory links;
  private final Schedules schedules;
  private final FleetRuntime runtime;
  private final PendingSubmissions pendingSubmissions = new PendingSubmissions();
  private final ActorSystem<ManagerMessage> system;
  private final ManagerCalls manager;
  private final AgentHealth health;
  private final RobotAgents robotAgents;
  private final FleetMonitor monitor;
  private final CompletableFuture<Void> failed = new CompletableFuture<>();
  private volatile boolean isClosing;

  /** The time of a tick that the manager has not taken; a later one takes its place. */
  private final AtomicReference<@Nullable Instant> dueTick = new AtomicReference<>();

  /**
   * Reads the store and goes on with what is in it, when all agents have started.
   *
   * @param floors at least one; the first is the default
   * @param scheduleStore what {@link #schedules} writes to
   * @param clock for the times in the history
   * @param now of the time that {@link #tick} brings
   * @throws IllegalStateException an agent cannot start; the message says which one and why
   */
  public AgentFleet(
      List<FloorMap> floors,
      FleetStore store,
      ScheduleStore scheduleStore,
      RobotLinkFactory links,
      AllocationMethod method,
      FleetRules rules,
      InstantSource clock,
      Instant now) {
    this(floors, store, scheduleStore, links, method, rules, clock, now, FleetRuntime.USUAL);
  }

  public AgentFleet(
      List<FloorMap> floors,
      FleetStore store,
      ScheduleStore scheduleStore,
      RobotLinkFactory links,
      AllocationMethod method,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      FleetRuntime runtime) {
    this.floors = List.copyOf(floors);
    this.runtime = runtime;
    this.latestSnapshot =
        new LatestSnapshot(FleetSnapshot.initial(clock.instant(), store.pause().orElse(null)));
    OrderChecks checks = OrderChecks.of(runtime, rules.checksPerUser());
    this.system =
        ActorSystem.create(
            ManagerAgent.of(
                floors,
                store,
                links,
                method,
                rules,
                clock,
                now,
                runtime,
                latestSnapshot,
                pendingSubmissions,
                checks),
            "toqa",
            AgentSystemSetup.of(runtime));
    this.manager = new ManagerCalls(system, checks);
    this.links = links;
    this.schedules = new StoredSchedules(scheduleStore, this, clock);
    this.health = AgentHealth.of(system);
    this.robotAgents = RobotAgents.of(system);
    awaitStart();
    var _ = system.getWhenTerminated().whenComplete((done, failure) -> ended());
    var _ = health.broken().thenRun(this::ended);
    this.monitor =
        new FleetMonitor(
            this::agentFailures, () -> health.warnings(runtime.monotonicNanos()), latestSnapshot);
  }

  private void awaitStart() {
    try {
      CompletableFuture.anyOf(
              health.started().toCompletableFuture(),
              system.getWhenTerminated().toCompletableFuture())
          .join();
      health.started().toCompletableFuture().getNow(null);
    } catch (CompletionException e) {
      terminate();
      throw e.getCause() instanceof IllegalStateException refusal
          ? refusal
          : new IllegalStateException("The fleet cannot start: " + e.getMessage(), e);
    }
  }

  private void ended() {
    if (!isClosing && failed.complete(null)) {
      log.error("The agents have ended; the fleet cannot go on.");
    }
  }

  private List<Sentence> agentFailures() {
    return failed.isDone()
        ? List.of(Phrase.FLEET_ENDED.with())
        : health.failures(runtime.monotonicNanos());
  }

  /** Time goes on: timers fire, robots are pinged, waiting tasks are looked at. */
  public void tick(Instant now) {
    health.recordTick(runtime.monotonicNanos());
    robotAgents.tick(now);
    if (dueTick.getAndSet(now) == null) {
      system.tell(new ManagerMessage.Tick(() -> requireNonNull(dueTick.getAndSet(null))));
    }
  }

  /** By that time all floors have done what was due, but for their last tick. */
  public Instant floorTime() {
    return health.floorTime();
  }

  @Override
  public CompletionStage<Answer<TaskView>> submit(TaskOrder order, String user, UUID key) {
    long deadline = TaskSubmitter.deadline(runtime.nanoTime());
    return manager.askChecked(
        user,
        (check, replyTo) ->
            new ManagerMessage.SubmitTask(order, user, key, deadline, check, replyTo));
  }

  @Override
  public CompletionStage<BatchAnswer> submitAll(
      List<TaskOrder> orders, List<@Nullable OrderPart> parts, String user, List<UUID> keys) {
    long deadline = TaskSubmitter.deadline(runtime.nanoTime());
    return manager.askChecked(
        user,
        (check, replyTo) ->
            new ManagerMessage.SubmitTasks(orders, parts, user, keys, deadline, check, replyTo));
  }

  @Override
  public boolean isSubmissionPending(UUID key) {
    return pendingSubmissions.contains(key);
  }

  @Override
  public CompletionStage<List<BatchAnswer.Rejection>> rejections(
      List<TaskOrder> orders, String user) {
    return manager.askChecked(
        user, (check, replyTo) -> new ManagerMessage.ValidateOrders(orders, user, check, replyTo));
  }

  @Override
  public CompletionStage<Answer<TaskPreview>> preview(TaskOrder order, String user) {
    return manager.askChecked(
        user, (check, replyTo) -> new ManagerMessage.PreviewTask(order, user, check, replyTo));
  }

  @Override
  public CompletionStage<Answer<PathAnswer>> path(PathQuestion question, String user) {
    return manager.askChecked(
        user, (check, replyTo) -> new ManagerMessage.FindPath(question, check, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> addRobot(RobotOrder order, String user) {
    return manager.ask(replyTo -> new ManagerMessage.AddRobot(order, user, replyTo));
  }

  @Override
  public List<GatewayState> gateways() {
    return links.gateways();
  }

  @Override
  public CompletionStage<Answer<RobotView>> pairRobot(
      String robot, PairingOrder order, String user) {
    return manager.ask(replyTo -> new ManagerMessage.PairRobot(robot, order, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> changeRobot(
      String robot, RobotChange change, @Nullable RobotChange seen, String user) {
    return manager.ask(
        replyTo -> new ManagerMessage.ChangeRobot(robot, change, seen, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> removeRobot(String robot, String user) {
    return manager.ask(replyTo -> new ManagerMessage.RemoveRobot(robot, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> locateRobot(String robot, Pose pose, String user) {
    return manager.ask(replyTo -> new ManagerMessage.LocateRobot(robot, pose, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> takeOutOfService(String robot, String user) {
    return manager.ask(replyTo -> new ManagerMessage.SetInService(robot, false, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> putInService(String robot, String user) {
    return manager.ask(replyTo -> new ManagerMessage.SetInService(robot, true, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> holdRobot(String robot, String user) {
    return manager.ask(replyTo -> new ManagerMessage.HoldRobot(robot, true, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> resumeRobot(String robot, String user) {
    return manager.ask(replyTo -> new ManagerMessage.HoldRobot(robot, false, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> clearStops(
      String robot, Set<String> reasons, String user) {
    return manager.ask(
        replyTo -> new ManagerMessage.ClearStops(robot, Set.copyOf(reasons), user, replyTo));
  }

  @Override
  public CompletionStage<Answer<RobotView>> sendHome(String robot, String user) {
    return manager.ask(replyTo -> new ManagerMessage.SendHome(robot, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<TaskView>> commandTask(
      long task, MissionEvent.OperatorCommand command) {
    return manager.ask(replyTo -> new ManagerMessage.CommandTask(task, command, replyTo));
  }

  @Override
  public CompletionStage<Answer<TaskView>> editTask(
      long task, TaskOrder order, @Nullable TransportTask seen, String user) {
    return manager.askChecked(
        user,
        (check, replyTo) -> new ManagerMessage.EditTask(task, order, seen, user, check, replyTo));
  }

  @Override
  public CompletionStage<Answer<TaskView>> deleteTask(TaskView task, String user) {
    return manager.ask(replyTo -> new ManagerMessage.DeleteTask(task, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> pauseAll(String user) {
    return manager.ask(replyTo -> new ManagerMessage.SetPause(true, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> resumeAll(String user) {
    return manager.ask(replyTo -> new ManagerMessage.SetPause(false, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> holdFloor(String floor, String user) {
    return manager.ask(replyTo -> new ManagerMessage.HoldFloor(floor, true, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> resumeFloor(String floor, String user) {
    return manager.ask(replyTo -> new ManagerMessage.HoldFloor(floor, false, user, replyTo));
  }

  @Override
  public CompletionStage<Answer<Optional<String>>> chooseAllocator(
      String floor, Optional<String> allocator, String user) {
    return manager.ask(
        replyTo -> new ManagerMessage.ChooseAllocator(floor, allocator, user, replyTo));
  }

  @Override
  public Schedules schedules() {
    return schedules;
  }

  @Override
  public FloorEditing floorEditing() {
    throw new IllegalStateException("not yet");
  }

  @Override
  public List<FloorMap> floors() {
    return floors;
  }

  @Override
  public SnapshotFeed snapshots() {
    return latestSnapshot;
  }

  @Override
  public List<Sentence> failures() {
    return monitor.failures();
  }

  /** How many messages of robots were left out, by their kind, since the start. */
  public long passedOver(RobotMessageKind kind) {
    return health.passedOver(kind);
  }

  /** Completes when the agents have ended though nobody closed them: nothing moves any more. */
  public CompletionStage<Void> whenFailed() {
    return failed;
  }

  /**
   * From now on also what this finds is a reason why the fleet cannot go on.
   *
   * @param check called by any thread, every second and more often; it does not wait
   */
  public void addCheck(Supplier<Optional<Sentence>> check) {
    monitor.addCheck(check);
  }

  /** From now on also what this finds is among the alerts of snapshots; the fleet goes on. */
  public void addWarning(Supplier<Optional<Sentence>> check) {
    monitor.addWarning(check);
  }

  /** Ends the agents: links are closed, what was handed to the store is written. */
  @Override
  public void close() {
    monitor.close();
    terminate();
  }

  private void terminate() {
    isClosing = true;
    system.terminate();
    try {
      system.getWhenTerminated().toCompletableFuture().get(10, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (TimeoutException | java.util.concurrent.ExecutionException e) {
      log.warn("The agents did not end in time.", e);
    }
  }
}
