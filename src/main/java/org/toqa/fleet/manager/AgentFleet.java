package org.toqa.fleet.manager;

import java.time.Instant;
import java.time.InstantSource;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.apache.pekko.actor.typed.ActorSystem;
import org.apache.pekko.actor.typed.javadsl.AskPattern;
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
import org.toqa.fleet.FloorListener;
import org.toqa.fleet.FloorStore;
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
import org.toqa.fleet.RobotView;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.Schedules;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.StoreWriter;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskPreview;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.dispatch.AgentSystemSetup;
import org.toqa.fleet.dispatch.DispatchCalls;
import org.toqa.fleet.dispatch.FloorFleet;
import org.toqa.fleet.dispatch.LatestSnapshot;
import org.toqa.fleet.dispatch.OrderChecks;
import org.toqa.fleet.dispatch.PendingSubmissions;
import org.toqa.fleet.dispatch.SharedParts;
import org.toqa.fleet.dispatch.StoreHealthCheck;
import org.toqa.fleet.dispatch.TaskFloors;
import org.toqa.fleet.dispatch.TaskSubmitter;
import org.toqa.fleet.robot.AgentHealth;
import org.toqa.fleet.schedule.StoredSchedules;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.gateway.GatewayState;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The fleet as systems of agents: one for each floor, and one agent for what holds for all of them.
 * It hands on what concerns a floor; floors share nothing but the store and the threads, so that
 * one that fails disturbs no other.
 *
 * <p>It reads no clock for its decisions: whoever started it calls {@link #tick} about ten times a
 * second, with real or with simulated time.
 */
public final class AgentFleet implements Fleet, AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(AgentFleet.class);
  private static final int CLOSE_SECONDS = 10;

  private final FleetStore store;
  private final SharedParts shared;
  private final FloorDirectory floors = new FloorDirectory();
  private final RobotFloors robots;
  private final Schedules schedules;
  private final SiteSnapshots snapshots;
  private final StoreWriter batchWriter;
  private final TaskBatches batches;
  private final ActorSystem<ManagerMessage> manager;
  private final FleetMonitor monitor;
  private final FloorEditor editor;
  private final FloorRouter router;
  private final List<Consumer<FloorMap>> mapListeners = new CopyOnWriteArrayList<>();
  private final List<MoveListener> moveListeners = new CopyOnWriteArrayList<>();
  private final List<FloorListener> floorListeners = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Void> failed = new CompletableFuture<>();
  private volatile boolean isClosing;

  /** As the agents apply it. */
  private volatile @Nullable Hold pause;

  /** Of the time that {@link #tick} brings. */
  private volatile Instant now;

  /**
   * Reads the store and goes on with what is in it, when all agents have started.
   *
   * @param floorStore has one floor at least; the first is the default
   * @param scheduleStore what {@link #schedules} writes to
   * @param clock for the times in the history
   * @param now of the time that {@link #tick} brings
   * @throws IllegalStateException no floor can start; the message says why
   */
  public AgentFleet(
      FloorStore floorStore,
      FleetStore store,
      ScheduleStore scheduleStore,
      RobotLinkFactory links,
      AllocationMethod method,
      FleetRules rules,
      InstantSource clock,
      Instant now) {
    this(floorStore, store, scheduleStore, links, method, rules, clock, now, FleetRuntime.USUAL);
  }

  public AgentFleet(
      FloorStore floorStore,
      FleetStore store,
      ScheduleStore scheduleStore,
      RobotLinkFactory links,
      AllocationMethod method,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      FleetRuntime runtime) {
    this.store = store;
    this.now = now;
    this.pause = store.pause().orElse(null);
    this.robots = new RobotFloors(store.robots());
    this.shared =
        new SharedParts(
            store,
            links,
            method,
            rules,
            clock,
            runtime,
            OrderChecks.of(runtime, rules.checksPerUser()),
            new PendingSubmissions(),
            new TaskFloors(),
            new StoreHealthCheck(
                store, clock, answers -> forEachRunning(floor -> floor.tellStoreHealth(answers))));
    this.schedules = new StoredSchedules(scheduleStore, this, clock);
    this.snapshots =
        new SiteSnapshots(
            clock.instant(),
            pause,
            () -> floors.all().stream().<SnapshotFeed>map(FloorEntry::snapshots).toList());
    this.batchWriter = new StoreWriter("batches", runtime, store::inOneTransaction, change -> {});
    this.batches =
        new TaskBatches(
            floors,
            new TaskSubmitter(store, batchWriter, shared.pendingSubmissions(), runtime::nanoTime));
    this.manager =
        ActorSystem.create(
            ManagerAgent.of(store, clock, runtime, pause, this::applyPause),
            "manager",
            AgentSystemSetup.of(runtime));
    this.editor =
        new FloorEditor(
            floorStore,
            scheduleStore,
            floors,
            robots,
            shared,
            floorListeners,
            this::startFloor,
            this::restartFloor);
    try {
      startAll(floorStore.floors());
    } catch (RuntimeException e) {
      editor.close();
      close(floors.all());
      throw e;
    }
    this.monitor = new FleetMonitor(floors::all, this::managerFailures, snapshots);
    this.router = new FloorRouter(floors, robots, shared.taskFloors(), findMissingFloors());
  }

  private void startAll(List<FloorMap> maps) {
    @Nullable RuntimeException first = null;
    for (FloorMap map : maps) {
      try {
        startFloor(map);
      } catch (IllegalStateException e) {
        log.error("{}", e.getMessage(), e);
        first = first == null ? e : first;
      }
    }
    if (first != null && floors.all().stream().allMatch(f -> f.agents().isEmpty())) {
      throw first;
    }
  }

  /** A floor begins; of one that cannot start, the directory knows why. */
  private void startFloor(FloorMap map) {
    LatestSnapshot feed =
        new LatestSnapshot(
            FleetSnapshot.initial(shared.clock().instant(), pause), this::renewSnapshots);
    FloorEntry entry = new FloorEntry(map, feed);
    floors.add(entry);
    snapshots.renew();
    entry.start(() -> agents(map, feed));
  }

  private FloorFleet restartFloor(FloorEntry entry, FloorMap map) {
    mapListeners.forEach(listener -> listener.accept(map));
    return agents(map, entry.snapshots());
  }

  private void renewSnapshots() {
    snapshots.renew();
  }

  /** A floor's agents, in place of others or for the first time. */
  private FloorFleet agents(FloorMap map, LatestSnapshot feed) {
    FloorFleet agents = new FloorFleet(map, shared, feed, pause, now);
    var _ = agents.whenFailed().thenRun(this::ended);
    manager.tell(new ManagerMessage.FloorStarted(agents));
    return agents;
  }

  private void ended() {
    if (!isClosing && failed.complete(null)) {
      log.error("The agents of a floor have ended; the fleet cannot go on.");
    }
  }

  private void applyPause(@Nullable Hold next) {
    pause = next;
    forEachRunning(floor -> floor.applyPause(next));
    snapshots.setPause(next);
  }

  private void forEachRunning(Consumer<FloorFleet> command) {
    floors.all().forEach(floor -> floor.ifRunning(command));
  }

  /** A floor that has another name now leaves robots and tasks behind, which people must know. */
  private MissingFloors findMissingFloors() {
    MissingFloors missing = MissingFloors.of(store, name -> floors.find(name).isPresent());
    missing.sentences().forEach((floor, said) -> addWarning(() -> missing.alert(floor)));
    return missing;
  }

  private List<Sentence> managerFailures() {
    return failed.isDone()
        ? List.of(Phrase.FLEET_ENDED.with())
        : AgentHealth.of(manager).failures(shared.runtime().monotonicNanos());
  }

  /** Time goes on: timers fire, robots are pinged, waiting tasks are looked at. */
  public void tick(Instant time) {
    now = time;
    forEachRunning(floor -> floor.tick(time));
  }

  /** By that time all floors have done what was due, but for their last tick. */
  public Instant floorTime() {
    return floors.all().stream()
        .flatMap(floor -> floor.agents().stream())
        .map(FloorFleet::floorTime)
        .min(Comparator.naturalOrder())
        .orElse(Instant.MAX);
  }

  @Override
  public CompletionStage<Answer<TaskView>> submit(TaskOrder order, Orderer by, UUID key) {
    return router.askResolved(
        order.floor(), order.start(), order.goal(), floor -> floor.submit(order, by, key));
  }

  @Override
  public CompletionStage<BatchAnswer> submitAll(
      List<TaskOrder> orders, List<@Nullable OrderPart> parts, Orderer by, List<UUID> keys) {
    return batches.submit(
        orders, parts, by, keys, TaskSubmitter.deadline(shared.runtime().nanoTime()));
  }

  @Override
  public boolean isSubmissionPending(UUID key) {
    return shared.pendingSubmissions().contains(key);
  }

  @Override
  public CompletionStage<List<BatchAnswer.Rejection>> rejections(
      List<TaskOrder> orders, String user) {
    return batches.rejections(orders, user);
  }

  @Override
  public <T> CompletionStage<T> decide(
      TaskOrder order, String user, Function<Optional<BatchAnswer.Rejection>, T> decision) {
    return batches.decide(order, user, decision);
  }

  @Override
  public CompletionStage<Answer<TaskPreview>> preview(TaskOrder order, String user) {
    return router.askResolved(
        order.floor(), order.start(), order.goal(), floor -> floor.preview(order, user));
  }

  @Override
  public CompletionStage<Answer<PathAnswer>> path(PathQuestion question, String user) {
    return router.askResolved(
        question.floor(), question.start(), question.goal(), floor -> floor.path(question, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> addRobot(RobotOrder order, String user) {
    Optional<FloorEntry> floor = floors.resolve(order.floor());
    if (floor.isEmpty()) {
      return CompletableFuture.completedFuture(
          new Answer.Rejected<>("floor", floors.noSuchFloor(order.floor())));
    }
    if (!robots.reserve(order.name(), floor.get().name())) {
      return CompletableFuture.completedFuture(
          new Answer.Rejected<>("name", Phrase.ROBOT_NAME_TAKEN.with(order.name())));
    }
    AtomicBoolean isAsked = new AtomicBoolean();
    CompletionStage<Answer<RobotView>> added =
        floor
            .get()
            .ask(
                agents -> {
                  isAsked.set(true); // from now on its agents know whether it is stored
                  return agents.addRobot(order, user, () -> robots.remove(order.name()));
                });
    return FloorEntry.orIfRemoved(
            added, () -> new Answer.Rejected<>("floor", floors.noSuchFloor(order.floor())))
        .whenComplete(
            (answer, failure) -> {
              if (!isAsked.get()) {
                robots.remove(order.name());
              }
            });
  }

  @Override
  public List<GatewayState> gateways() {
    return shared.links().gateways();
  }

  @Override
  public CompletionStage<Answer<RobotView>> pairRobot(
      String robot, PairingOrder order, String user) {
    return router.askFloorOf(robot, floor -> floor.pairRobot(robot, order, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> changeRobot(
      String robot, RobotChange change, @Nullable RobotChange seen, String user) {
    return router.askFloorOf(robot, floor -> floor.changeRobot(robot, change, seen, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> removeRobot(String robot, String user) {
    return router
        .askFloorOf(robot, floor -> floor.removeRobot(robot, user))
        .whenComplete(
            (answer, failure) -> {
              if (answer instanceof Answer.Accepted<RobotView>) {
                robots.remove(robot);
              }
            });
  }

  @Override
  public CompletionStage<Answer<RobotView>> moveRobot(String robot, RobotMove move, String user) {
    return new RobotMover(floors, robots, moveListeners).move(robot, move, user);
  }

  @Override
  public CompletionStage<Answer<RobotView>> locateRobot(String robot, Pose pose, String user) {
    return router.askFloorOf(robot, floor -> floor.locateRobot(robot, pose, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> takeOutOfService(String robot, String user) {
    return router.askFloorOf(robot, floor -> floor.setInService(robot, false, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> putInService(String robot, String user) {
    return router.askFloorOf(robot, floor -> floor.setInService(robot, true, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> holdRobot(String robot, String user) {
    return router.askFloorOfAtOnce(robot, floor -> floor.holdRobot(robot, true, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> resumeRobot(String robot, String user) {
    return router.askFloorOf(robot, floor -> floor.holdRobot(robot, false, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> clearStops(
      String robot, Set<String> reasons, String user) {
    return router.askFloorOf(robot, floor -> floor.clearStops(robot, reasons, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> sendHome(String robot, String user) {
    return router.askFloorOf(robot, floor -> floor.sendHome(robot, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> sendTo(String robot, Vec2 place) {
    return router.askFloorOf(robot, floor -> floor.sendTo(robot, place));
  }

  @Override
  public CompletionStage<Answer<ManualAnswer>> driveByHand(
      String robot, ManualOrder order, String user) {
    return router.askFloorOfAtOnce(robot, floor -> floor.driveByHand(robot, order, user));
  }

  @Override
  public CompletionStage<Answer<RobotView>> endManualDrive(String robot, UUID lease, String user) {
    return router.askFloorOfAtOnce(robot, floor -> floor.endManualDrive(robot, lease, user));
  }

  @Override
  public CompletionStage<Answer<TaskView>> commandTask(
      long task, MissionEvent.OperatorCommand command) {
    return command instanceof MissionEvent.Hold
        ? router.askFloorOfTaskAtOnce(task, floor -> floor.commandTask(task, command))
        : router.askFloorOfTask(task, floor -> floor.commandTask(task, command));
  }

  @Override
  public CompletionStage<Answer<TaskView>> editTask(
      long task, TaskOrder order, @Nullable TransportTask seen, String user) {
    String named = order.floor();
    if (named != null && floors.find(named).isEmpty()) {
      return CompletableFuture.completedFuture(
          new Answer.Rejected<>("floor", floors.noSuchFloor(named)));
    }
    return router.askFloorOfTask(
        task,
        floor ->
            named == null || floor.floor().name().equals(named)
                ? floor.editTask(task, order, seen, user)
                : CompletableFuture.completedFuture(
                    new Answer.Rejected<>(
                        "floor", Phrase.TASK_STAYS_ON_FLOOR.with(floor.floor().name()))));
  }

  @Override
  public CompletionStage<Answer<TaskView>> deleteTask(TaskView task, String user) {
    return floors
        .find(task.task().floor())
        .or(() -> floors.all().stream().findFirst())
        .map(entry -> entry.ask(floor -> floor.deleteTask(task, user)))
        .orElseGet(
            () -> CompletableFuture.completedFuture(FloorDirectory.unknown(task.task().floor())));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> pauseAll(String user) {
    return setPause(true, user);
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> resumeAll(String user) {
    return setPause(false, user);
  }

  private CompletionStage<Answer<Optional<Hold>>> setPause(boolean pauses, String user) {
    return AskPattern.askWithStatus(
        manager,
        replyTo -> new ManagerMessage.SetPause(pauses, user, replyTo),
        DispatchCalls.ANSWER_LIMIT,
        manager.scheduler());
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> holdFloor(String floor, String user) {
    return router.askFloorAtOnce(floor, agents -> agents.hold(true, user));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> resumeFloor(String floor, String user) {
    return router.askFloor(floor, agents -> agents.hold(false, user));
  }

  @Override
  public CompletionStage<Answer<Optional<String>>> chooseAllocator(
      String floor, Optional<String> allocator, String user) {
    return router.askFloor(floor, agents -> agents.chooseAllocator(allocator, user));
  }

  @Override
  public Schedules schedules() {
    return schedules;
  }

  @Override
  public FloorEditing floorEditing() {
    return editor;
  }

  @Override
  public List<FloorMap> floors() {
    return floors.maps();
  }

  @Override
  public SnapshotFeed snapshots() {
    return snapshots;
  }

  @Override
  public Optional<SnapshotFeed> snapshots(String floor) {
    return floors.find(floor).map(FloorEntry::snapshots);
  }

  @Override
  public List<Sentence> failures(String floor) {
    return floors.find(floor).map(FloorEntry::failures).orElse(List.of());
  }

  @Override
  public List<Sentence> failures() {
    return monitor.failures();
  }

  /** How many messages of robots were left out, by their kind, since the start. */
  public long passedOver(RobotMessageKind kind) {
    return floors.all().stream()
        .flatMap(floor -> floor.agents().stream())
        .mapToLong(agents -> agents.passedOver(kind))
        .sum();
  }

  /**
   * From now on the listener is told of each map that comes in force on a floor that there is.
   *
   * @param listener called before robots are planned on it
   */
  public void addMapListener(Consumer<FloorMap> listener) {
    mapListeners.add(listener);
  }

  /**
   * From now on the listener is told of each robot that was carried to another floor.
   *
   * @param listener called when it is stored, before the robot is told
   */
  public void addMoveListener(MoveListener listener) {
    moveListeners.add(listener);
  }

  /** From now on the listener is asked and told of each floor that is removed. */
  public void addFloorListener(FloorListener listener) {
    floorListeners.add(listener);
  }

  /**
   * A robot's sensors beside its link see this now. It counts as what the robot itself reports: as
   * far as it is believed, from where the robot says next that it is.
   *
   * @param ranges metres from its rim
   * @param angles radians, counter-clockwise from straight ahead; as many
   */
  public void tellRanges(String robot, List<Double> ranges, List<Double> angles) {
    floors
        .all()
        .forEach(floor -> floor.ifRunning(agents -> agents.tellRanges(robot, ranges, angles)));
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

  /** The same of what people should see to; it is no fault of the fleet's. */
  public void addAdviser(Supplier<Optional<Sentence>> adviser) {
    monitor.addAdviser(adviser);
  }

  @Override
  public List<Sentence> advice() {
    return monitor.advice();
  }

  @Override
  public void showBoxes(String floor, List<BoxView> boxes) {
    for (FloorEntry entry : floors.all()) {
      if (entry.name().equals(floor)) {
        entry.snapshots().setBoxes(boxes);
        entry.ifRunning(agents -> agents.tellBoxes(boxes));
      }
    }
  }

  /** From now on what this finds of robots, by name, is an alert of theirs; they go on. */
  public void addRobotCheck(Supplier<Map<String, Sentence>> check) {
    monitor.addRobotCheck(check);
  }

  /** Ends the agents: links are closed, what was handed to the store is written. */
  @Override
  public void close() {
    monitor.close();
    editor.close();
    close(floors.all());
  }

  private void close(List<FloorEntry> running) {
    isClosing = true;
    shared.storeHealth().close();
    running.parallelStream().forEach(FloorEntry::close);
    batchWriter.close();
    manager.terminate();
    try {
      manager.getWhenTerminated().toCompletableFuture().get(CLOSE_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (TimeoutException | ExecutionException e) {
      log.warn("The manager did not end in time.", e);
    }
  }
}
