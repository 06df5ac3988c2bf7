package org.toqa.fleet.manager;

import static java.util.Objects.requireNonNull;

import java.time.Instant;
import java.time.InstantSource;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.PostStop;
import org.apache.pekko.actor.typed.javadsl.AbstractBehavior;
import org.apache.pekko.actor.typed.javadsl.ActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.apache.pekko.actor.typed.javadsl.Receive;
import org.apache.pekko.pattern.StatusReply;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.allocation.AllocationMethod;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.floor.FloorAgent;
import org.toqa.fleet.floor.FloorDistances;
import org.toqa.fleet.floor.FloorEvent;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.fleet.floor.StoredFloorState;
import org.toqa.fleet.robot.AgentHealth;
import org.toqa.fleet.robot.RobotAgents;
import org.toqa.fleet.robot.Supervision;
import org.toqa.grid.FloorMap;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.gateway.GatewayState;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Takes tasks, keeps their queue, decides who carries what, and publishes snapshots of the whole
 * fleet. An accepted task is stored before its caller is answered; robots are given it by its
 * floor.
 */
final class ManagerAgent extends AbstractBehavior<ManagerMessage> {
  private static final Logger log = LoggerFactory.getLogger(ManagerAgent.class);

  private final FleetState fleet;
  private final AgentHealth health;
  private final StoreHealthCheck storeHealth;
  private final HoldCommandHandler holdCommands;
  private final LateTaskReporter lateTasks;
  private final FloorAllocators allocators;
  private final RoundDecider decider;
  private final AllocationRounds rounds;
  private final SnapshotPublisher snapshotPublisher;
  private final TaskCommandHandler taskCommands;
  private final TaskChangeHandler taskChanges;
  private final RobotCommandHandler robotCommands;

  private final FloorTicks floorTicks;

  static Behavior<ManagerMessage> of(
      List<FloorMap> floors,
      FleetStore store,
      RobotLinkFactory links,
      AllocationMethod method,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      FleetRuntime runtime,
      LatestSnapshot latest,
      PendingSubmissions pendingSubmissions,
      OrderChecks checks) {
    return Supervision.resuming(
        Phrase.MANAGER_PART.with(),
        ManagerMessage.class,
        runtime,
        Behaviors.setup(
            context ->
                new ManagerAgent(
                    context,
                    floors,
                    store,
                    links,
                    method,
                    rules,
                    clock,
                    now,
                    runtime,
                    latest,
                    pendingSubmissions,
                    checks)));
  }

  private ManagerAgent(
      ActorContext<ManagerMessage> context,
      List<FloorMap> floorMaps,
      FleetStore store,
      RobotLinkFactory links,
      AllocationMethod method,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      FleetRuntime runtime,
      LatestSnapshot latest,
      PendingSubmissions pendingSubmissions,
      OrderChecks checks) {
    super(context);
    this.health = AgentHealth.of(context.getSystem());
    this.fleet =
        new FleetState(
            store,
            clock,
            now,
            runtime,
            change -> health.recordLeftOut(change, runtime.monotonicNanos()));
    ActorRef<ManagerMessage> self = context.getSelf();
    this.floorTicks = new FloorTicks(this::tickFloor, runtime::monotonicNanos);
    this.storeHealth =
        new StoreHealthCheck(
            store, answers -> self.tell(new ManagerMessage.StoreHealthChanged(answers)));
    RobotAgents robotAgents = RobotAgents.of(context.getSystem());
    this.holdCommands =
        new HoldCommandHandler(store, fleet.writer, clock, self, fleet.floors, robotAgents);
    List<OpenTask> open = store.openTasks();
    Set<Long> toldBefore = open.stream().map(t -> t.mission().id()).collect(Collectors.toSet());
    PathQuery paths = new PathQuery(checks.fleetExecutor());
    OrderValidator validator =
        new OrderValidator(
            floorMaps,
            links.gateways().stream()
                .map(GatewayState::name)
                .collect(Collectors.toUnmodifiableSet()),
            paths);
    this.lateTasks = new LateTaskReporter(fleet, new DeadlineWatch(rules.pace(), toldBefore), self);
    this.allocators = new FloorAllocators(fleet, method, self);
    health.expectStart();
    this.decider =
        new RoundDecider(
            allocators::method, context.spawn(NegotiationAgent.of(now, runtime), "negotiation"));
    this.rounds = new AllocationRounds(fleet, decider, paths, self);
    this.snapshotPublisher =
        new SnapshotPublisher(
            fleet, rounds, allocators, lateTasks, holdCommands, storeHealth, latest);
    this.taskCommands =
        new TaskCommandHandler(
            fleet,
            rounds,
            lateTasks,
            storeHealth,
            validator,
            decider,
            paths,
            snapshotPublisher,
            pendingSubmissions,
            self);
    this.taskChanges =
        new TaskChangeHandler(fleet, validator, storeHealth, snapshotPublisher, self);
    this.robotCommands =
        new RobotCommandHandler(
            fleet,
            snapshotPublisher,
            validator,
            new RobotRegistrar(links, store, fleet.writer, clock, runtime),
            self,
            robotAgents);
    recover(floorMaps, open, links, rules, now);
    log.info(
        "{} robots, {} tasks not ended, {} of them queued.",
        fleet.robots.size(),
        open.size(),
        fleet.queue.size());
  }

  private void recover(
      List<FloorMap> floorMaps,
      List<OpenTask> open,
      RobotLinkFactory links,
      FleetRules rules,
      Instant now) {
    FleetStore store = fleet.store;
    List<StoredRobot> stored = store.storedRobots();
    List<OpenTask> leftLoads = store.tasksWithLeftLoads();
    fleet.legs.recover(open, store.endedLegs());
    stored.forEach(r -> fleet.robots.put(r.name(), r.record()));
    findMissingFloors(floorMaps, open, stored);
    open.stream()
        .filter(
            t ->
                t.mission().state() == TaskState.QUEUED
                    || fleet.missingFloors.containsKey(t.mission().task().floor()))
        .forEach(t -> fleet.queue.add(t.mission(), t.changedAt(), true));
    ActorRef<FloorEvent> floorEvents =
        getContext().messageAdapter(FloorEvent.class, ManagerMessage.FromFloor::new);
    for (FloorMap floor : floorMaps) {
      StoredFloorState memory =
          new StoredFloorState(
              stored.stream().filter(r -> r.record().floor().equals(floor.name())).toList(),
              holdCommands.pause(),
              holdCommands.floorHold(floor.name()),
              open.stream()
                  .filter(t -> t.mission().state() != TaskState.QUEUED)
                  .filter(t -> t.mission().task().floor().equals(floor.name()))
                  .toList(),
              leftLoads.stream()
                  .filter(t -> t.mission().task().floor().equals(floor.name()))
                  .toList());
      health.expectStart();
      ActorRef<FloorMessage> agent =
          getContext()
              .spawn(
                  FloorAgent.of(
                      floor,
                      memory,
                      store,
                      links,
                      rules,
                      fleet.clock,
                      now,
                      fleet.runtime,
                      floorEvents),
                  "floor-" + fleet.floors.size());
      fleet.floors.put(floor.name(), agent);
      fleet.floorMaps.put(floor.name(), floor);
      fleet.distances.put(floor.name(), new FloorDistances(floor.grid()));
      fleet.dueFloors.add(floor.name());
    }
  }

  /** A map that has another name now leaves robots and tasks behind, which people must know. */
  private void findMissingFloors(
      List<FloorMap> floorMaps, List<OpenTask> open, List<StoredRobot> stored) {
    List<String> robots = stored.stream().map(robot -> robot.record().floor()).toList();
    List<String> tasks = open.stream().map(task -> task.mission().task().floor()).toList();
    Stream.concat(robots.stream(), tasks.stream())
        .filter(floor -> floorMaps.stream().noneMatch(map -> map.name().equals(floor)))
        .distinct()
        .forEach(
            floor -> {
              Sentence said =
                  Phrase.FLOOR_IS_MISSING.with(
                      floor,
                      Collections.frequency(robots, floor),
                      Collections.frequency(tasks, floor));
              fleet.missingFloors.put(floor, said);
              log.warn("{}", said.english());
            });
  }

  @Override
  public Receive<ManagerMessage> createReceive() {
    return newReceiveBuilder()
        .onAnyMessage(this::handle)
        .onSignal(PostStop.class, signal -> stopped())
        .build();
  }

  private Behavior<ManagerMessage> handle(ManagerMessage message) {
    switch (message) {
      case ManagerMessage.SubmitTask m -> taskCommands.submitTask(m);
      case ManagerMessage.OrderChecked m -> taskCommands.orderChecked(m);
      case ManagerMessage.SubmitTasks m -> taskCommands.submitTasks(m);
      case ManagerMessage.OrdersChecked m -> taskCommands.ordersChecked(m);
      case ManagerMessage.ValidateOrders m -> taskCommands.validateOrders(m);
      case ManagerMessage.TasksStored m -> taskCommands.tasksStored(m);
      case ManagerMessage.FindPath m -> taskCommands.findPath(m);
      case ManagerMessage.PreviewTask m -> taskCommands.previewTask(m);
      case ManagerMessage.PreviewOrderChecked m -> taskCommands.previewOrderChecked(m);
      case ManagerMessage.TaskStored m -> taskCommands.taskStored(m);
      case ManagerMessage.AddRobot m -> robotCommands.addRobot(m);
      case ManagerMessage.RobotStored m -> robotCommands.robotStored(m);
      case ManagerMessage.RobotNotStored m -> robotCommands.robotNotStored(m.robot());
      case ManagerMessage.RobotReread m -> robotCommands.robotReread(m);
      case ManagerMessage.RobotPaired m -> robotCommands.robotPaired(m);
      case ManagerMessage.PairRobot m -> robotCommands.pairRobot(m);
      case ManagerMessage.ChangeRobot m -> robotCommands.changeRobot(m);
      case ManagerMessage.RobotChanged m -> robotCommands.robotChanged(m);
      case ManagerMessage.RemoveRobot m ->
          robotCommands.forwardToFloor(
              m.robot(),
              m.replyTo(),
              new FloorMessage.RemoveRobot(m.robot(), m.user(), m.replyTo()));
      case ManagerMessage.LocateRobot m -> robotCommands.locateRobot(m);
      case ManagerMessage.SetInService m -> robotCommands.setInService(m);
      case ManagerMessage.HoldRobot m -> robotCommands.holdRobot(m);
      case ManagerMessage.ClearStops m ->
          robotCommands.forwardToFloor(
              m.robot(),
              m.replyTo(),
              new FloorMessage.ClearStops(m.robot(), m.reasons(), m.user(), m.replyTo()));
      case ManagerMessage.SendHome m ->
          robotCommands.forwardToFloor(
              m.robot(), m.replyTo(), new FloorMessage.SendHome(m.robot(), m.user(), m.replyTo()));
      case ManagerMessage.EditTask m -> taskChanges.edit(m);
      case ManagerMessage.EditChecked m -> taskCommands.commandTask(TaskChangeHandler.command(m));
      case ManagerMessage.DeleteTask m -> taskChanges.delete(m);
      case ManagerMessage.TaskDeleted m -> taskChanges.deleted(m.request());
      case ManagerMessage.CommandTask m -> taskCommands.commandTask(m);
      case ManagerMessage.TaskCommandStored m -> taskCommands.taskCommandStored(m);
      case ManagerMessage.SetPause m -> {
        holdCommands.setPause(m);
        fleet.changed = true;
      }
      case ManagerMessage.PauseEnded m -> {
        holdCommands.pauseEnded(m.number());
        fleet.changed = true;
      }
      case ManagerMessage.HoldFloor m -> holdCommands.setFloorHold(m);
      case ManagerMessage.PauseLasts m -> holdCommands.pauseLasts(m.number());
      case ManagerMessage.FloorHoldLasts m -> holdCommands.floorHoldLasts(m);
      case ManagerMessage.FloorHoldEnded m -> holdCommands.floorHoldEnded(m);
      case ManagerMessage.ChooseAllocator m -> allocators.choose(m);
      case ManagerMessage.AllocatorStored m -> {
        allocators.stored(m.command());
        snapshotPublisher.publish(); // first, so that who is answered sees it
        m.command()
            .replyTo()
            .tell(StatusReply.success(new Answer.Accepted<>(m.command().allocator())));
      }
      case ManagerMessage.FromFloor m -> handle(m.event());
      case ManagerMessage.AllocationDecided m -> rounds.allocationDecided(m);
      case ManagerMessage.DeadlinesChecked m -> lateTasks.deadlinesChecked(m);
      case ManagerMessage.QueuedDeadlinesChecked m -> lateTasks.queuedDeadlinesChecked(m);
      case ManagerMessage.StoreHealthChanged m ->
          snapshotPublisher.publish(); // also where simulated time stands still
      case ManagerMessage.Tick m -> tick(m.latest().get());
    }
    return this;
  }

  private void handle(FloorEvent event) {
    switch (event) {
      case FloorEvent.RobotJoined e -> robotCommands.robotJoined(e);
      case FloorEvent.RobotRemoved e -> robotCommands.robotRemoved(e);
      case FloorEvent.TaskReturned e -> requeue(e.mission());
      case FloorEvent.TaskBegun e -> fleet.handedOver.remove(e.task());
      case FloorEvent.TaskNotBegun e -> requeue(e.mission());
      case FloorEvent.TaskUnknown e ->
          taskCommands.commandTask(
              new ManagerMessage.CommandTask(e.task(), e.command(), e.replyTo()));
      case FloorEvent.FloorReport e -> floorReported(e);
      case FloorEvent.Ticked e -> floorTicked(e.floor());
    }
  }

  private void floorReported(FloorEvent.FloorReport m) {
    fleet.reports.put(m.floor().name(), m);
    m.missions().forEach(fleet::recordLeg);
    m.ended().forEach(fleet::addEnded);
    fleet.changed = true;
    rounds.floorReported(m.floor().name());
  }

  private void requeue(Mission mission) {
    fleet.handedOver.remove(mission.id());
    fleet.enqueue(mission, fleet.clock.instant());
    fleet.changed = true;
  }

  /** What changes is in the snapshot when every floor has done its tick, or at the next tick. */
  private void tick(Instant now) {
    fleet.now = now;
    if (floorTicks.isRunning() || fleet.floors.isEmpty()) {
      publishIfChanged();
    }
    floorTicks.tick(fleet.floors.keySet(), now);
    health.recordFloorTime(floorTicks.floorTime());
    decider.tick(now);
    rounds.beginDueRounds();
    lateTasks.check(now);
  }

  private void tickFloor(String floor, Instant now) {
    requireNonNull(fleet.floors.get(floor)).tell(new FloorMessage.Tick(now));
  }

  private void floorTicked(String floor) {
    floorTicks.end(floor);
    health.recordTickDone(floorTicks.runningSince());
    health.recordFloorTime(floorTicks.floorTime());
    if (!floorTicks.isRunning()) {
      publishIfChanged();
    }
  }

  private void publishIfChanged() {
    if (fleet.changed) {
      snapshotPublisher.publish();
    }
  }

  private Behavior<ManagerMessage> stopped() {
    storeHealth.close();
    fleet.writer.close();
    return this;
  }
}
