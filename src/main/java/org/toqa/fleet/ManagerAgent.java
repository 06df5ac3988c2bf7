package org.toqa.fleet;

import java.time.Instant;
import java.time.InstantSource;
import java.util.HashSet;
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
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.allocation.Allocator;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.grid.FloorMap;
import org.toqa.link.RobotLinks;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskState;

/**
 * Takes tasks, keeps their queue, decides who carries what, and hangs up the picture of the whole
 * fleet. An accepted task is stored before its asker is answered; robots are given it by its floor.
 */
final class ManagerAgent extends AbstractBehavior<ManagerMessage> {
  private static final Logger log = LoggerFactory.getLogger(ManagerAgent.class);

  private final FleetState fleet;
  private final StoreWatch storeWatch;
  private final Holds holds;
  private final LateTasks late;
  private final AllocationRounds rounds;
  private final FleetPicture picture;
  private final TaskDesk tasks;
  private final RobotDesk robots;

  /** Floors whose tick is under way. */
  private final Set<String> ticking = new HashSet<>();

  static Behavior<ManagerMessage> of(
      List<FloorMap> floors,
      FleetStore store,
      RobotLinks links,
      Allocator allocator,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      SnapshotBoard board) {
    return AgentFleet.goingOn(
        Behaviors.setup(
            context ->
                new ManagerAgent(
                    context, floors, store, links, allocator, rules, clock, now, board)));
  }

  private ManagerAgent(
      ActorContext<ManagerMessage> context,
      List<FloorMap> floorMaps,
      FleetStore store,
      RobotLinks links,
      Allocator allocator,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      SnapshotBoard board) {
    super(context);
    this.fleet = new FleetState(store, clock);
    ActorRef<ManagerMessage> self = context.getSelf();
    this.storeWatch =
        new StoreWatch(store, answers -> self.tell(new ManagerMessage.StoreWatched(answers)));
    this.holds = new Holds(store, fleet.writer, clock, self, fleet.floors);
    List<OpenTask> open = store.openTasks();
    Set<Long> toldBefore = open.stream().map(t -> t.mission().id()).collect(Collectors.toSet());
    OrderCheck check = new OrderCheck(floorMaps);
    this.late = new LateTasks(fleet, new DeadlineWatch(rules.pace(), toldBefore));
    this.rounds = new AllocationRounds(fleet, allocator, self);
    this.picture = new FleetPicture(fleet, rounds, late, holds, storeWatch, board);
    this.tasks = new TaskDesk(fleet, rounds, late, storeWatch, check, allocator, self);
    this.robots =
        new RobotDesk(
            fleet, picture, check, new RobotIntake(links, store, fleet.writer, clock), self);
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
      RobotLinks links,
      FleetRules rules,
      Instant now) {
    FleetStore store = fleet.store;
    List<RobotRecord> stored = store.robots();
    Set<String> outOfService = store.outOfService();
    Set<String> held = store.held();
    List<ChargeRecord> charges = store.charges();
    stored.forEach(r -> fleet.robots.put(r.name(), r));
    open.stream()
        .filter(t -> t.mission().state() == TaskState.QUEUED)
        .forEach(t -> fleet.queue.add(t.mission(), t.changedAt(), true));
    for (FloorMap floor : floorMaps) {
      FloorMemory memory =
          new FloorMemory(
              stored.stream().filter(r -> r.floor().equals(floor.name())).toList(),
              outOfService,
              held,
              charges,
              holds.pause(),
              holds.of(floor.name()),
              open.stream()
                  .filter(t -> t.mission().state() != TaskState.QUEUED)
                  .filter(t -> t.mission().task().floor().equals(floor.name()))
                  .toList());
      ActorRef<FloorMessage> agent =
          getContext()
              .spawn(
                  FloorAgent.of(
                      floor, memory, store, links, rules, fleet.clock, now, getContext().getSelf()),
                  "floor-" + fleet.floors.size());
      fleet.floors.put(floor.name(), agent);
      fleet.maps.put(floor.name(), floor);
      fleet.distances.put(floor.name(), new FloorDistances(floor.grid()));
      fleet.due.add(floor.name());
    }
  }

  @Override
  public Receive<ManagerMessage> createReceive() {
    return newReceiveBuilder()
        .onAnyMessage(this::on)
        .onSignal(PostStop.class, signal -> closed())
        .build();
  }

  private Behavior<ManagerMessage> on(ManagerMessage message) {
    switch (message) {
      case ManagerMessage.Submit m -> tasks.submit(m);
      case ManagerMessage.SubmitAll m -> tasks.submitAll(m);
      case ManagerMessage.CheckAll m -> tasks.checkAll(m);
      case ManagerMessage.AllStored m -> tasks.allStored(m);
      case ManagerMessage.PreviewTask m -> tasks.preview(m);
      case ManagerMessage.TaskStored m -> tasks.taskStored(m);
      case ManagerMessage.AddRobot m -> robots.addRobot(m);
      case ManagerMessage.RobotStored m -> robots.robotStored(m);
      case ManagerMessage.RobotJoined m -> robots.joined(m);
      case ManagerMessage.RobotNotStored m -> fleet.robots.remove(m.robot());
      case ManagerMessage.RobotNotChanged m -> fleet.robots.put(m.robot().name(), m.robot());
      case ManagerMessage.PairRobot m -> robots.pair(m);
      case ManagerMessage.ChangeRobot m -> robots.change(m);
      case ManagerMessage.RobotChanged m -> robots.changed(m);
      case ManagerMessage.RemoveRobot m ->
          robots.tellFloorOf(
              m.robot(),
              m.replyTo(),
              new FloorMessage.RemoveRobot(m.robot(), m.user(), m.replyTo()));
      case ManagerMessage.RobotRemoved m -> robots.removed(m);
      case ManagerMessage.Locate m -> robots.locate(m);
      case ManagerMessage.Serve m -> robots.serve(m);
      case ManagerMessage.HoldRobot m ->
          robots.tellFloorOf(
              m.robot(),
              m.replyTo(),
              new FloorMessage.HoldRobot(m.robot(), m.hold(), m.user(), m.replyTo()));
      case ManagerMessage.SendHome m ->
          robots.tellFloorOf(
              m.robot(), m.replyTo(), new FloorMessage.SendHome(m.robot(), m.user(), m.replyTo()));
      case ManagerMessage.Wished m -> tasks.wished(m);
      case ManagerMessage.WishStored m -> tasks.wishStored(m.mission());
      case ManagerMessage.Pause m -> {
        holds.pause(m);
        fleet.changed = true;
      }
      case ManagerMessage.PauseEnded m -> {
        holds.pauseEnded();
        fleet.changed = true;
      }
      case ManagerMessage.HoldFloor m -> holds.hold(m);
      case ManagerMessage.FloorHoldEnded m -> holds.holdEnded(m.floor());
      case ManagerMessage.Returned m -> requeue(m.mission());
      case ManagerMessage.Begun m -> fleet.handedOver.remove(m.task());
      case ManagerMessage.NotBegun m -> requeue(m.mission());
      case ManagerMessage.FloorReport m -> reported(m);
      case ManagerMessage.Ticked m -> ticked(m.floor());
      case ManagerMessage.Decided m -> rounds.decided(m);
      case ManagerMessage.StoreWatched m ->
          picture.publish(); // also where simulated time stands still
      case ManagerMessage.Tick m -> tick(m.now());
    }
    return this;
  }

  private void reported(ManagerMessage.FloorReport m) {
    fleet.reports.put(m.floor().name(), m);
    m.ended().forEach(fleet::shelve);
    fleet.changed = true;
    rounds.reported(m.floor().name());
  }

  private void requeue(Mission mission) {
    fleet.handedOver.remove(mission.id());
    fleet.queue.add(mission, fleet.clock.instant(), true);
    fleet.changed = true;
    fleet.due.add(mission.task().floor());
  }

  /** What changes is in the picture when every floor has done its tick, or at the next tick. */
  private void tick(Instant now) {
    if (!ticking.isEmpty() || fleet.floors.isEmpty()) {
      publishWhatChanged();
    }
    fleet.floors.values().forEach(f -> f.tell(new FloorMessage.Tick(now)));
    ticking.addAll(fleet.floors.keySet());
    rounds.begin();
    late.look(now);
  }

  private void ticked(String floor) {
    ticking.remove(floor);
    if (ticking.isEmpty()) {
      publishWhatChanged();
    }
  }

  private void publishWhatChanged() {
    if (fleet.changed) {
      picture.publish();
    }
  }

  private Behavior<ManagerMessage> closed() {
    storeWatch.close();
    fleet.writer.close();
    return this;
  }
}
