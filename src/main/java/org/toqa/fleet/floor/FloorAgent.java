package org.toqa.fleet.floor;

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
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.robot.AgentHealth;
import org.toqa.fleet.robot.RobotAgent;
import org.toqa.fleet.robot.RobotEvent;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.fleet.robot.Supervision;
import org.toqa.grid.FloorMap;
import org.toqa.link.RobotLinkFactory;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.floor.FloorTraffic;
import org.toqa.traffic.mapf.LacamJointPlanner;
import org.toqa.wording.Phrase;

/**
 * The single writer of one floor: its map, its missions and who may drive where.
 *
 * <p>An event goes through {@code mission -> store -> command}: the mission's next state is stored,
 * and only then its commands become goals of drives. A robot that has a goal and is stopped is sent
 * a drive to it; that is decided anew at every tick, so that whatever was lost in between (a
 * message, a connection, a server) is made up for.
 */
public final class FloorAgent extends AbstractBehavior<FloorMessage> {
  /** For a plan for all robots; a function of the machine's speed, not of the floor's time. */
  private static final Duration PLANNING_LIMIT = Duration.ofMillis(200);

  private final RobotLinkFactory links;
  private final ActorRef<FloorEvent> manager;
  private final FloorState state;
  private final FloorWatch watch;
  private final FloorReporter reports;
  private final FloorMissions missions;
  private final HoldDispatcher holds;
  private final HomeDispatcher homing;
  private final ChargingDispatcher charging;
  private final OperatorCommandHandler operatorCommands;
  private final ClearCommandHandler clearCommands;
  private final RobotEventHandler robotEventHandler;
  private final ActorRef<RobotEvent> robotEvents;
  private final ArmDispatcher arms;
  private final DriveDispatcher drives;
  private final ManualDriveHandler manualDrives;

  /** How many robots have come, those included that were removed. */
  private long joined;

  public static Behavior<FloorMessage> of(
      FloorMap floor,
      StoredFloorState memory,
      FleetStore store,
      RobotLinkFactory links,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      FleetRuntime runtime,
      ActorRef<FloorEvent> manager) {
    return Supervision.resuming(
        Phrase.FLOOR_PART.with(floor.name()),
        FloorMessage.class,
        runtime,
        Behaviors.setup(
            context ->
                new FloorAgent(
                    context, floor, memory, store, links, rules, clock, now, runtime, manager)));
  }

  private FloorAgent(
      ActorContext<FloorMessage> context,
      FloorMap floor,
      StoredFloorState memory,
      FleetStore store,
      RobotLinkFactory links,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      FleetRuntime runtime,
      ActorRef<FloorEvent> manager) {
    super(context);
    this.links = links;
    this.manager = manager;
    FloorTraffic traffic =
        new FloorTraffic(
            floor.grid(),
            floor.margins(),
            floor.moves(),
            new TimedPlanner(new LacamJointPlanner(), runtime),
            apart -> new TimedLifelongPlanner(FloorTraffic.rollingPlanner(apart), runtime),
            () -> Deadline.in(PLANNING_LIMIT, runtime::nanoTime),
            runtime.boundedExecutor("planning-" + floor.name(), 1));
    state =
        new FloorState(
            floor,
            store,
            clock,
            traffic,
            new ChargerWatch(rules.charging().patience()),
            now,
            runtime,
            change ->
                AgentHealth.of(context.getSystem())
                    .recordLeftOut(change, runtime.monotonicNanos()));
    watch = new FloorWatch(floor, traffic);
    reports = new FloorReporter(state, watch, rules.charging().until(), manager);
    missions =
        new FloorMissions(
            state,
            reports,
            new RobotWatch(rules.reassignAfter()),
            rules.pace(),
            context.getSelf(),
            manager);
    state.hold = memory.hold();
    holds = new HoldDispatcher(state, memory.pause());
    homing = new HomeDispatcher(state);
    charging = new ChargingDispatcher(state, missions, rules.charging(), context.getSelf());
    arms = new ArmDispatcher(state, missions);
    robotEventHandler = new RobotEventHandler(state, missions, holds, watch, arms);
    operatorCommands =
        new OperatorCommandHandler(
            state, reports, missions, holds, homing, robotEventHandler, context.getSelf());
    clearCommands = new ClearCommandHandler(state, reports, context.getSelf());
    robotEvents = context.messageAdapter(RobotEvent.class, FloorMessage.FromRobot::new);
    drives = new DriveDispatcher(state, missions, arms);
    manualDrives = new ManualDriveHandler(state, reports, drives);
    memory.robots().forEach(this::startRobot);
    memory.robots().forEach(stored -> charging.recover(stored.charge()));
    memory.leftLoads().forEach(ended -> state.leftLoads.update(ended.mission(), ended.changedAt()));
    memory.robots().forEach(robotEventHandler::recoverReport); // places of groups follow from it
    memory.begunTasks().forEach(missions::recover);
    memory.robots().forEach(robotEventHandler::recoverPlace);
  }

  @Override
  public Receive<FloorMessage> createReceive() {
    return newReceiveBuilder()
        .onAnyMessage(this::handle)
        .onSignal(PostStop.class, signal -> stopped())
        .build();
  }

  private Behavior<FloorMessage> handle(FloorMessage message) {
    switch (message) {
      case FloorMessage.BeginTask m -> missions.beginTask(m);
      case FloorMessage.ExchangeTasks m -> missions.exchangeTasks(m);
      case FloorMessage.LoadLeft m -> {
        state.leftLoads.update(m.mission(), m.endedAt());
        state.changed = true;
      }
      case FloorMessage.BoxesSeen m -> state.leftLoads.setBoxes(m.boxes());
      case FloorMessage.CommandTask m -> missions.commandTask(m);
      case FloorMessage.StepStored m -> missions.stepStored(m.step());
      case FloorMessage.SetPause m -> holds.setPause(m.pause());
      case FloorMessage.HoldFloor m -> holds.setFloorHold(m.hold());
      case FloorMessage.HoldRobot m -> operatorCommands.holdRobot(m);
      case FloorMessage.ResumeStored m -> operatorCommands.resumeStored(m);
      case FloorMessage.ResumeNotStored m -> operatorCommands.resumeNotStored(m);
      case FloorMessage.ClearStops m -> clearCommands.clearStops(m);
      case FloorMessage.ClearStored m -> clearCommands.clearStored(m.command());
      case FloorMessage.SendHome m -> operatorCommands.sendHome(m);
      case FloorMessage.SendTo m -> operatorCommands.sendTo(m);
      case FloorMessage.DriveByHand m -> manualDrives.drive(m);
      case FloorMessage.EndManualDrive m -> manualDrives.end(m);
      case FloorMessage.LocateRobot m -> operatorCommands.locateRobot(m);
      case FloorMessage.SetInService m -> operatorCommands.setInService(m);
      case FloorMessage.ServiceStored m ->
          operatorCommands.serviceStored(m.command(), m.freesCells());
      case FloorMessage.RechargeRobots m -> charging.requestRecharge(m);
      case FloorMessage.ChargeStored m -> charging.turnStored(m);
      case FloorMessage.AddRobot m -> addRobot(m);
      case FloorMessage.RobotChanged m -> operatorCommands.robotChanged(m);
      case FloorMessage.RemoveRobot m -> operatorCommands.removeRobot(m);
      case FloorMessage.RobotRemoved m -> robotRemoved(m);
      case FloorMessage.FromRobot m -> robotEventHandler.handle(m.event());
      case FloorMessage.Tick m -> {
        try {
          tick(m.now());
        } finally { // or there would never be another tick
          manager.tell(new FloorEvent.Ticked());
        }
      }
    }
    return this;
  }

  private void addRobot(FloorMessage.AddRobot m) {
    FloorRobot robot = startRobot(m.robot());
    charging.recover(m.robot().charge());
    robotEventHandler.recoverReport(m.robot());
    robotEventHandler.recoverPlace(m.robot());
    reports.send();
    manager.tell(new FloorEvent.RobotJoined(reports.view(robot), m.replyTo()));
  }

  private void robotRemoved(FloorMessage.RobotRemoved m) {
    FloorRobot robot = state.robots.remove(m.command().robot());
    if (robot == null) {
      m.command().replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.command().robot())));
      return;
    }
    if (state.traffic.hasRobot(robot.name())) {
      state.traffic.removeRobot(robot.name());
    }
    robot.agent.tell(new RobotMessage.Stop());
    reports.send();
    manager.tell(new FloorEvent.RobotRemoved(reports.view(robot), m.command().replyTo()));
  }

  private FloorRobot startRobot(StoredRobot stored) {
    RobotRecord record = stored.record();
    AgentHealth health = AgentHealth.of(getContext().getSystem());
    health.expectStart();
    ActorRef<RobotMessage> agent =
        getContext()
            .spawn(
                state.runtime.agent(
                    "robot-" + record.name(),
                    RobotAgent.of(
                        record,
                        robotEvents,
                        state.store,
                        state.writer,
                        links,
                        state.now,
                        state.runtime)),
                "robot-" + ++joined);
    FloorRobot robot =
        new FloorRobot(
            record,
            new OperatorSettings(!stored.outOfService(), stored.held()),
            agent,
            new StoreLimit(health, () -> state.now),
            state.now);
    state.robots.put(record.name(), robot);
    state.changed = true;
    return robot;
  }

  private void tick(Instant time) {
    state.now = time;
    charging.update();
    state.formations.updateTraffic();
    for (FloorRobot robot : state.robots.values()) {
      robotEventHandler.updateStoreLimit(robot);
      robotEventHandler.locateCarried(robot);
      robot.obedience.update(time);
      missions.checkRobot(robot);
      holds.updateHold(robot);
      manualDrives.update(robot);
      homing.sendIdleHome(robot);
      drives.updateRobot(robot);
    }
    missions.updatePassableLoads();
    state.addRobotLines(
        watch.updateObstacles(state.leftLoads.cells(), state.leftLoads.passable(), time));
    drives.applyTrafficDecisions();
    state.addToHistory(watch.updateStandstills(holds::mayStand));
    if (state.changed) {
      reports.send();
    }
  }

  private Behavior<FloorMessage> stopped() {
    state.writer.close();
    return this;
  }
}
