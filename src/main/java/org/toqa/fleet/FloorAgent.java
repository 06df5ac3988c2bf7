package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.PostStop;
import org.apache.pekko.actor.typed.javadsl.AbstractBehavior;
import org.apache.pekko.actor.typed.javadsl.ActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.apache.pekko.actor.typed.javadsl.Receive;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.grid.FloorMap;
import org.toqa.link.RobotLinks;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.floor.FloorTraffic;
import org.toqa.traffic.oneshot.LacamFloorPlanner;

/**
 * The single writer of one floor: its map, its missions and who may drive where.
 *
 * <p>An event goes through {@code mission -> store -> command}: the mission's next state is stored,
 * and only then its commands become errands of robots. A robot that has an errand and stands is
 * sent a way for it; that is decided anew at every tick, so that whatever was lost on the road (a
 * message, a connection, a server) is made up for.
 */
final class FloorAgent extends AbstractBehavior<FloorMessage> {
  /** For a plan for all robots; a function of the machine's speed, not of the floor's time. */
  private static final Duration PLANNING_LIMIT = Duration.ofMillis(200);

  private final RobotLinks links;
  private final ActorRef<ManagerMessage> manager;
  private final FloorState state;
  private final FloorWatch watch;
  private final FloorReports reports;
  private final FloorMissions missions;
  private final Holding holding;
  private final Homing homing;
  private final Charging charging;
  private final RobotWishes wishes;
  private final Reception reception;
  private final Driving driving;

  /** How many robots have come, those included that were removed. */
  private long joined;

  static Behavior<FloorMessage> of(
      FloorMap floor,
      FloorMemory memory,
      FleetStore store,
      RobotLinks links,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      ActorRef<ManagerMessage> manager) {
    return AgentFleet.goingOn(
        Behaviors.setup(
            context ->
                new FloorAgent(context, floor, memory, store, links, rules, clock, now, manager)));
  }

  private FloorAgent(
      ActorContext<FloorMessage> context,
      FloorMap floor,
      FloorMemory memory,
      FleetStore store,
      RobotLinks links,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      ActorRef<ManagerMessage> manager) {
    super(context);
    this.links = links;
    this.manager = manager;
    FloorTraffic traffic =
        new FloorTraffic(
            floor.grid(),
            new LacamFloorPlanner(),
            () -> Deadline.in(PLANNING_LIMIT, System::nanoTime));
    state =
        new FloorState(
            floor, store, clock, traffic, new ChargerWatch(rules.charging().patience()), now);
    watch = new FloorWatch(floor, traffic);
    reports = new FloorReports(state, watch, manager);
    missions =
        new FloorMissions(
            state, reports, new RobotWatch(rules.lostAfter()), context.getSelf(), manager);
    state.hold = memory.hold();
    holding = new Holding(state, memory.pause());
    homing = new Homing(state);
    charging = new Charging(state, missions, rules.charging(), context.getSelf());
    wishes = new RobotWishes(state, reports, missions, holding, homing, context.getSelf());
    reception = new Reception(state, missions, holding, watch);
    driving = new Driving(state, missions);
    for (RobotRecord record : memory.robots()) {
      FloorRobot robot = join(record);
      robot.inService = !memory.outOfService().contains(record.name());
      robot.held = memory.held().contains(record.name());
    }
    memory.charges().forEach(charging::recover);
    memory.begun().forEach(missions::recover);
  }

  @Override
  public Receive<FloorMessage> createReceive() {
    return newReceiveBuilder()
        .onAnyMessage(this::on)
        .onSignal(PostStop.class, signal -> closed())
        .build();
  }

  private Behavior<FloorMessage> on(FloorMessage message) {
    switch (message) {
      case FloorMessage.Begin m -> missions.begin(m);
      case FloorMessage.Exchange m -> missions.exchange(m);
      case FloorMessage.Wished m -> missions.wished(m);
      case FloorMessage.Stored m -> missions.stored(m.step());
      case FloorMessage.Pause m -> holding.pause(m.pause());
      case FloorMessage.HoldFloor m -> holding.holdFloor(m.hold());
      case FloorMessage.HoldRobot m -> wishes.hold(m);
      case FloorMessage.SendHome m -> wishes.sendHome(m);
      case FloorMessage.Locate m -> wishes.locate(m);
      case FloorMessage.Serve m -> wishes.serve(m);
      case FloorMessage.ServiceStored m -> wishes.serviceStored(m.wish(), m.clears());
      case FloorMessage.Recharge m -> charging.isWanted(m);
      case FloorMessage.ChargeStored m -> charging.stored(m);
      case FloorMessage.RobotJoined m -> joined(m);
      case FloorMessage.RobotChanged m -> wishes.changed(m);
      case FloorMessage.RemoveRobot m -> wishes.remove(m);
      case FloorMessage.RobotRemoved m -> removed(m);
      case FloorMessage.FromRobot m -> reception.fromRobot(m);
      case FloorMessage.Tick m -> tick(m.now());
    }
    return this;
  }

  private void joined(FloorMessage.RobotJoined m) {
    FloorRobot robot = join(m.robot());
    reports.send();
    manager.tell(new ManagerMessage.RobotJoined(reports.view(robot), m.replyTo()));
  }

  private void removed(FloorMessage.RobotRemoved m) {
    FloorRobot robot = state.robots.remove(m.wish().robot());
    if (robot == null) {
      m.wish().replyTo().tell(StatusReply.success(FloorState.unknown(m.wish().robot())));
      return;
    }
    if (state.traffic.knows(robot.name())) {
      state.traffic.leaves(robot.name());
    }
    robot.agent.tell(new RobotMessage.Stop());
    reports.send();
    manager.tell(new ManagerMessage.RobotRemoved(reports.view(robot), m.wish().replyTo()));
  }

  private FloorRobot join(RobotRecord record) {
    ActorRef<RobotMessage> agent =
        getContext()
            .spawn(
                RobotAgent.of(record, getContext().getSelf(), state.store, links, state.now),
                "robot-" + ++joined);
    FloorRobot robot = new FloorRobot(record, agent, state.now);
    state.robots.put(record.name(), robot);
    state.changed = true;
    return robot;
  }

  private void tick(Instant time) {
    state.now = time;
    state.robots.values().forEach(r -> r.agent.tell(new RobotMessage.Tick(time)));
    charging.look();
    state.formations.tellTraffic();
    for (FloorRobot robot : state.robots.values()) {
      missions.watch(robot);
      holding.holdOrGoOn(robot);
      homing.sendHomeWhenIdle(robot);
      driving.direct(robot);
    }
    state.note(watch.tellObstacles(time));
    driving.decide();
    state.note(watch.askStandstills(holding::isHeldLately));
    if (state.changed) {
      reports.send();
    }
    manager.tell(new ManagerMessage.Ticked(state.floor.name()));
  }

  private Behavior<FloorMessage> closed() {
    state.writer.close();
    return this;
  }
}
