package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.PostStop;
import org.apache.pekko.actor.typed.javadsl.AbstractBehavior;
import org.apache.pekko.actor.typed.javadsl.ActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.apache.pekko.actor.typed.javadsl.Receive;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.Hold;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.floor.FloorAgent;
import org.toqa.fleet.floor.FloorEvent;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.fleet.floor.StoredFloorState;
import org.toqa.fleet.robot.AgentHealth;
import org.toqa.fleet.robot.RobotAgents;
import org.toqa.fleet.robot.Supervision;
import org.toqa.grid.FloorMap;
import org.toqa.link.gateway.GatewayState;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;

/**
 * Takes the tasks of a floor, keeps their queue, decides who carries what, and publishes snapshots
 * of the floor. An accepted task is stored before its caller is answered; robots are given it by
 * the floor's agent.
 */
final class DispatchAgent extends AbstractBehavior<DispatchMessage> {
  private static final Logger log = LoggerFactory.getLogger(DispatchAgent.class);

  private final DispatchState state;
  private final AgentHealth health;
  private final StoreHealthCheck storeHealth;
  private final FloorHoldHandler holds;
  private final LateTaskReporter lateTasks;
  private final TaskForecaster forecaster;
  private final AllocatorChoice allocator;
  private final RoundDecider decider;
  private final AllocationRounds rounds;
  private final SnapshotPublisher snapshotPublisher;
  private final TaskCommandHandler taskCommands;
  private final TaskChangeHandler taskChanges;
  private final RobotCommandHandler robotCommands;

  private final FloorTicks floorTicks;

  /**
   * @param pause of all floors, as it is now
   */
  static Behavior<DispatchMessage> of(
      FloorMap floor,
      SharedParts shared,
      LatestSnapshot latest,
      @Nullable Hold pause,
      Instant now) {
    return Supervision.resuming(
        Phrase.DISPATCH_PART.with(floor.name()),
        DispatchMessage.class,
        shared.runtime(),
        Behaviors.setup(context -> new DispatchAgent(context, floor, shared, latest, pause, now)));
  }

  private DispatchAgent(
      ActorContext<DispatchMessage> context,
      FloorMap floor,
      SharedParts shared,
      LatestSnapshot latest,
      @Nullable Hold pause,
      Instant now) {
    super(context);
    FleetStore store = shared.store();
    FleetRuntime runtime = shared.runtime();
    this.health = AgentHealth.of(context.getSystem());
    this.storeHealth = shared.storeHealth();
    ActorRef<DispatchMessage> self = context.getSelf();
    List<StoredRobot> robots =
        store.storedRobots().stream().filter(r -> r.record().floor().equals(floor.name())).toList();
    List<OpenTask> open = onFloor(floor, store.openTasks());
    Hold floorHold = store.floorHolds().get(floor.name());
    StoredFloorState memory =
        new StoredFloorState(
            robots,
            pause,
            floorHold,
            open.stream().filter(t -> t.mission().state() != TaskState.QUEUED).toList(),
            onFloor(floor, store.tasksWithLeftLoads()));
    health.expectStart();
    ActorRef<FloorMessage> floorAgent =
        context.spawn(
            FloorAgent.of(
                floor,
                memory,
                store,
                shared.links(),
                shared.rules(),
                shared.clock(),
                now,
                runtime,
                context.messageAdapter(FloorEvent.class, DispatchMessage.FromFloor::new)),
            "floor");
    this.state =
        new DispatchState(
            floor,
            floorAgent,
            shared.taskFloors(),
            store,
            shared.clock(),
            now,
            runtime,
            change -> health.recordLeftOut(change, runtime.monotonicNanos()));
    this.floorTicks =
        new FloorTicks(
            time -> floorAgent.tell(new FloorMessage.Tick(time)), runtime::monotonicNanos);
    RobotAgents robotAgents = RobotAgents.of(context.getSystem());
    this.holds = new FloorHoldHandler(state, self, robotAgents, floorHold, pause);
    PathQuery paths = new PathQuery(shared.checks().fleetExecutor());
    OrderValidator validator =
        new OrderValidator(
            floor,
            shared.links().gateways().stream()
                .map(GatewayState::name)
                .collect(Collectors.toUnmodifiableSet()),
            paths);
    Set<Long> toldBefore = open.stream().map(t -> t.mission().id()).collect(Collectors.toSet());
    this.lateTasks =
        new LateTaskReporter(state, new DeadlineWatch(shared.rules().pace(), toldBefore), self);
    this.forecaster = new TaskForecaster(state, shared.rules(), self);
    this.allocator = new AllocatorChoice(state, shared.method(), self);
    health.expectStart();
    this.decider =
        new RoundDecider(
            allocator::method, context.spawn(NegotiationAgent.of(now, runtime), "negotiation"));
    this.rounds = new AllocationRounds(state, decider, paths, self);
    this.snapshotPublisher =
        new SnapshotPublisher(
            state, rounds, allocator, lateTasks, forecaster, holds, storeHealth, latest);
    this.taskCommands =
        new TaskCommandHandler(
            state,
            rounds,
            lateTasks,
            storeHealth,
            validator,
            decider,
            paths,
            snapshotPublisher,
            shared.pendingSubmissions(),
            self);
    this.taskChanges =
        new TaskChangeHandler(state, validator, storeHealth, snapshotPublisher, self);
    this.robotCommands =
        new RobotCommandHandler(
            state,
            snapshotPublisher,
            validator,
            new RobotRegistrar(shared.links(), store, state.writer, shared.clock(), runtime),
            self,
            robotAgents);
    recover(robots, open, onFloor(floor, store.endedLegs()));
    state.setLeftLoads(memory.leftLoads().stream().map(t -> t.mission().id()));
    log.info(
        "{}: {} robots, {} tasks not ended, {} of them queued.",
        floor.name(),
        robots.size(),
        open.size(),
        state.queue.size());
  }

  private static List<OpenTask> onFloor(FloorMap floor, List<OpenTask> tasks) {
    return tasks.stream().filter(t -> t.mission().task().floor().equals(floor.name())).toList();
  }

  private void recover(List<StoredRobot> robots, List<OpenTask> open, List<OpenTask> endedLegs) {
    state.legs.recover(open, endedLegs);
    robots.forEach(r -> state.robots.put(r.name(), r.record()));
    open.forEach(t -> state.recover(t.mission(), t.changedAt()));
  }

  @Override
  public Receive<DispatchMessage> createReceive() {
    return newReceiveBuilder()
        .onAnyMessage(this::handle)
        .onSignal(PostStop.class, signal -> stopped())
        .build();
  }

  private Behavior<DispatchMessage> handle(DispatchMessage message) {
    switch (message) {
      case DispatchMessage.SubmitTask m -> taskCommands.submitTask(m);
      case DispatchMessage.OrderChecked m -> taskCommands.orderChecked(m);
      case DispatchMessage.SubmitTasks m -> taskCommands.submitTasks(m);
      case DispatchMessage.OrdersChecked m -> taskCommands.ordersChecked(m);
      case DispatchMessage.CheckOrders m -> taskCommands.checkOrders(m);
      case DispatchMessage.TasksStored m -> taskCommands.tasksStored(m);
      case DispatchMessage.FindPath m -> taskCommands.findPath(m);
      case DispatchMessage.PreviewTask m -> taskCommands.previewTask(m);
      case DispatchMessage.PreviewOrderChecked m -> taskCommands.previewOrderChecked(m);
      case DispatchMessage.TaskStored m -> taskCommands.taskStored(m);
      case DispatchMessage.AddRobot m -> robotCommands.addRobot(m);
      case DispatchMessage.RobotStored m -> robotCommands.robotStored(m);
      case DispatchMessage.RobotNotStored m -> robotCommands.robotNotStored(m.robot());
      case DispatchMessage.RobotReread m -> robotCommands.robotReread(m);
      case DispatchMessage.RobotPaired m -> robotCommands.robotPaired(m);
      case DispatchMessage.PairRobot m -> robotCommands.pairRobot(m);
      case DispatchMessage.ChangeRobot m -> robotCommands.changeRobot(m);
      case DispatchMessage.RobotChanged m -> robotCommands.robotChanged(m);
      case DispatchMessage.RemoveRobot m ->
          robotCommands.forwardToFloor(
              m.robot(),
              m.replyTo(),
              new FloorMessage.RemoveRobot(m.robot(), m.move(), m.user(), m.replyTo()));
      case DispatchMessage.TakeRobot m -> robotCommands.takeRobot(m);
      case DispatchMessage.RobotTaken m -> robotCommands.robotTaken(m);
      case DispatchMessage.LocateRobot m -> robotCommands.locateRobot(m);
      case DispatchMessage.SetInService m -> robotCommands.setInService(m);
      case DispatchMessage.HoldRobot m -> robotCommands.holdRobot(m);
      case DispatchMessage.ClearStops m ->
          robotCommands.forwardToFloor(
              m.robot(),
              m.replyTo(),
              new FloorMessage.ClearStops(m.robot(), m.reasons(), m.user(), m.replyTo()));
      case DispatchMessage.SendHome m ->
          robotCommands.forwardToFloor(
              m.robot(), m.replyTo(), new FloorMessage.SendHome(m.robot(), m.user(), m.replyTo()));
      case DispatchMessage.SendTo m ->
          robotCommands.forwardToFloor(
              m.robot(), m.replyTo(), new FloorMessage.SendTo(m.robot(), m.place(), m.replyTo()));
      case DispatchMessage.DriveByHand m ->
          robotCommands.forwardToFloor(
              m.robot(),
              m.replyTo(),
              new FloorMessage.DriveByHand(m.robot(), m.order(), m.user(), m.replyTo()));
      case DispatchMessage.EndManualDrive m ->
          robotCommands.forwardToFloor(
              m.robot(),
              m.replyTo(),
              new FloorMessage.EndManualDrive(m.robot(), m.lease(), m.user(), m.replyTo()));
      case DispatchMessage.EditTask m -> taskChanges.edit(m);
      case DispatchMessage.EditChecked m -> taskCommands.commandTask(TaskChangeHandler.command(m));
      case DispatchMessage.DeleteTask m -> taskChanges.delete(m);
      case DispatchMessage.TaskDeleted m -> taskChanges.deleted(m.request());
      case DispatchMessage.CommandTask m -> taskCommands.commandTask(m);
      case DispatchMessage.TaskCommandStored m -> taskCommands.taskCommandStored(m);
      case DispatchMessage.ApplyPause m -> {
        holds.applyPause(m.pause());
        state.changed = true;
      }
      case DispatchMessage.BoxesSeen m ->
          state.floorAgent.tell(new FloorMessage.BoxesSeen(m.boxes()));
      case DispatchMessage.HoldFloor m -> holds.setFloorHold(m);
      case DispatchMessage.FloorResumeEnded m -> holds.resumeEnded(m.ended());
      case DispatchMessage.ChooseAllocator m -> allocator.choose(m);
      case DispatchMessage.AllocatorStored m -> {
        allocator.stored(m.command());
        snapshotPublisher.publish(); // first, so that who is answered sees it
        m.command()
            .replyTo()
            .tell(StatusReply.success(new Answer.Accepted<>(m.command().allocator())));
      }
      case DispatchMessage.FromFloor m -> handle(m.event());
      case DispatchMessage.AllocationDecided m -> rounds.allocationDecided(m);
      case DispatchMessage.DeadlinesChecked m -> lateTasks.deadlinesChecked(m);
      case DispatchMessage.QueuedDeadlinesChecked m -> lateTasks.queuedDeadlinesChecked(m);
      case DispatchMessage.TasksForecast m -> forecaster.forecast(m.result());
      case DispatchMessage.StoreHealthChanged _ ->
          snapshotPublisher.publish(); // also where simulated time stands still
      case DispatchMessage.Tick m -> tick(m.latest().get());
    }
    return this;
  }

  private void handle(FloorEvent event) {
    switch (event) {
      case FloorEvent.RobotJoined e -> robotCommands.robotJoined(e);
      case FloorEvent.RobotRemoved e -> robotCommands.robotRemoved(e);
      case FloorEvent.TaskReturned e -> requeue(e.mission());
      case FloorEvent.TaskBegun e -> state.handedOver.remove(e.task());
      case FloorEvent.TaskNotBegun e -> requeue(e.mission());
      case FloorEvent.TaskUnknown e ->
          taskCommands.commandTask(
              new DispatchMessage.CommandTask(e.task(), e.command(), e.replyTo()));
      case FloorEvent.FloorReport e -> floorReported(e);
      case FloorEvent.Ticked _ -> floorTicked();
    }
  }

  private void floorReported(FloorEvent.FloorReport m) {
    state.setReport(m);
    m.missions().forEach(state::recordLeg);
    m.ended().forEach(state::addEnded);
    state.changed = true;
    rounds.floorReported();
  }

  private void requeue(Mission mission) {
    state.handedOver.remove(mission.id());
    state.enqueue(mission, state.clock.instant());
    state.changed = true;
  }

  /** What changes is in the snapshot when the floor has done its tick, or at the next tick. */
  private void tick(Instant now) {
    state.now = now;
    if (floorTicks.isRunning()) {
      publishIfChanged();
    }
    floorTicks.tick(now, state.isIdle());
    if (!floorTicks.isRunning()) {
      publishIfChanged(); // a floor that is idle is not told each time
    }
    health.recordFloorTime(floorTicks.floorTime());
    decider.tick(now);
    rounds.beginDueRound();
    lateTasks.check(now);
    forecaster.update(now);
  }

  private void floorTicked() {
    floorTicks.end();
    health.recordTickDone(floorTicks.runningSince());
    health.recordFloorTime(floorTicks.floorTime());
    if (!floorTicks.isRunning()) {
      publishIfChanged();
    }
  }

  private void publishIfChanged() {
    if (state.changed) {
      snapshotPublisher.publish();
    }
  }

  private Behavior<DispatchMessage> stopped() {
    state.writer.close();
    return this;
  }
}
