package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
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
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.FloorRobot.Errand;
import org.toqa.fleet.FloorWatch.Remark;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.link.RobotLinks;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.mission.Carrier;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionCommand;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Objection;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.motion.DriveSpeeds;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.floor.Decision;
import org.toqa.traffic.floor.FloorTraffic;
import org.toqa.traffic.floor.Route;
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
  private static final Logger log = LoggerFactory.getLogger(FloorAgent.class);
  private static final Duration RETRY_AFTER = Duration.ofSeconds(1);

  /** A robot that is needed again at once need not turn round. */
  private static final Duration HOME_AFTER = Duration.ofSeconds(3);

  private static final Duration STARTS_WITHIN = Duration.ofSeconds(30);

  /** Metres; whoever is so near to a place is there. */
  private static final double ARRIVED = 0.15;

  /** For a plan for all robots; a function of the machine's speed, not of the floor's time. */
  private static final Duration PLANNING_LIMIT = Duration.ofMillis(200);

  private final FloorMap floor;
  private final FleetStore store;
  private final RobotLinks links;
  private final InstantSource clock;
  private final ActorRef<ManagerMessage> manager;
  private final StoreWriter writer;
  private final FloorTraffic traffic;
  private final FloorWatch watch;
  private final RobotWatch robotWatch;

  private final Map<String, FloorRobot> robots = new TreeMap<>();
  private final Map<Long, OpenMission> missions = new LinkedHashMap<>();
  private final List<TaskView> ended = new ArrayList<>();
  private Instant now;
  private boolean changed = true;
  private @Nullable FleetPause pause;

  /** A mission, and when it last changed. */
  private record OpenMission(Mission mission, Instant changedAt) {}

  static Behavior<FloorMessage> of(
      FloorMap floor,
      FloorMemory memory,
      FleetStore store,
      RobotLinks links,
      Duration lostAfter,
      InstantSource clock,
      Instant now,
      ActorRef<ManagerMessage> manager) {
    return AgentFleet.goingOn(
        Behaviors.setup(
            context ->
                new FloorAgent(
                    context, floor, memory, store, links, lostAfter, clock, now, manager)));
  }

  private FloorAgent(
      ActorContext<FloorMessage> context,
      FloorMap floor,
      FloorMemory memory,
      FleetStore store,
      RobotLinks links,
      Duration lostAfter,
      InstantSource clock,
      Instant now,
      ActorRef<ManagerMessage> manager) {
    super(context);
    this.floor = floor;
    this.store = store;
    this.links = links;
    this.clock = clock;
    this.manager = manager;
    this.now = now;
    this.writer = new StoreWriter("floor-" + floor.name());
    this.traffic =
        new FloorTraffic(
            floor.grid(),
            new LacamFloorPlanner(),
            () -> Deadline.in(PLANNING_LIMIT, System::nanoTime));
    this.watch = new FloorWatch(floor, traffic);
    this.robotWatch = new RobotWatch(lostAfter);
    this.pause = memory.pause();
    for (RobotRecord record : memory.robots()) {
      FloorRobot robot = join(record);
      robot.inService = !memory.outOfService().contains(record.name());
      robot.held = memory.held().contains(record.name());
    }
    memory.begun().forEach(this::recover);
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
      case FloorMessage.Begin m -> begin(m);
      case FloorMessage.Wished m -> wished(m);
      case FloorMessage.Pause m -> pause(m.pause());
      case FloorMessage.HoldRobot m -> hold(m);
      case FloorMessage.SendHome m -> sendHome(m);
      case FloorMessage.RobotJoined m -> join(m.robot());
      case FloorMessage.Locate m -> locate(m);
      case FloorMessage.Serve m -> serve(m);
      case FloorMessage.ServiceStored m -> serviceStored(m.wish(), m.clears());
      case FloorMessage.Stored m -> stored(m.step());
      case FloorMessage.Tick m -> tick(m.now());
      case FloorMessage.FromRobot m -> fromRobot(m);
    }
    return this;
  }

  // --- missions ---------------------------------------------------------------------------------

  private void begin(FloorMessage.Begin m) {
    if (m.robots().stream().anyMatch(r -> isEngaged(r) || !isInService(r))) {
      manager.tell(new ManagerMessage.NotBegun(m.mission()));
      return;
    }
    for (String name : m.robots()) {
      missionOf(name).ifPresent(old -> happened(old, new MissionEvent.Retasked(name)));
    }
    Mission.Step step = m.mission().assign(m.robots(), m.why());
    Instant at = clock.instant();
    apply(
        step,
        at,
        step.history().stream()
            .map(
                text ->
                    new EventRecord(
                        at, "task.assigned", m.mission().id(), null, EventRecord.SYSTEM, text))
            .toList());
    report(); // first, so that the task is in every picture
    manager.tell(new ManagerMessage.Begun(m.mission().id()));
  }

  /** A mission that was under way when the server stopped goes on in the phase it was stored in. */
  private void recover(OpenTask open) {
    Mission mission = open.mission();
    missions.put(mission.id(), new OpenMission(mission, open.changedAt()));
    for (Carrier c : mission.carriers()) {
      FloorRobot robot = robots.get(c.robot());
      if (c.isDriving() && robot != null && !mission.isStopping()) {
        robot.errand = errand(mission, c.robot());
      }
    }
  }

  /** Whether it works for a mission that it cannot be taken from: it is not on its way home. */
  private boolean isEngaged(String robot) {
    return missionOf(robot)
        .flatMap(mission -> mission.carrier(robot))
        .filter(carrier -> carrier.phase() < 3)
        .isPresent();
  }

  private boolean isInService(String robot) {
    FloorRobot known = robots.get(robot);
    return known != null && known.inService;
  }

  private Optional<Mission> missionOf(String robot) {
    return missions.values().stream()
        .map(OpenMission::mission)
        .filter(m -> m.carrier(robot).filter(c -> !c.released()).isPresent())
        .findFirst();
  }

  private Mission happened(Mission mission, MissionEvent event) {
    Mission.Step step = mission.on(event);
    Instant at = clock.instant();
    apply(step, at, EventRecord.of(step, event, at));
    return step.mission();
  }

  private void happened(long task, MissionEvent event) {
    OpenMission open = missions.get(task);
    if (open != null) {
      happened(open.mission(), event);
    }
  }

  /** Stores the step; its commands are carried out when it is safe. */
  private void apply(Mission.Step step, Instant at, List<EventRecord> events) {
    if (!step.changed()) {
      return;
    }
    Mission mission = step.mission();
    if (mission.state().isEnded()) {
      missions.remove(mission.id());
      ended.add(view(new OpenMission(mission, at)));
    } else {
      missions.put(mission.id(), new OpenMission(mission, at));
    }
    changed = true;
    ActorRef<FloorMessage> self = getContext().getSelf();
    writer.write(
        () -> store.saveMission(mission, at, events),
        () -> self.tell(new FloorMessage.Stored(step)));
  }

  private void stored(Mission.Step step) {
    step.commands().forEach(command -> carryOut(step, command));
    OpenMission open = missions.get(step.mission().id());
    if (step.mission().state() == TaskState.QUEUED
        && open != null
        && open.mission().equals(step.mission())) {
      missions.remove(step.mission().id());
      manager.tell(new ManagerMessage.Returned(step.mission()));
      report();
    }
  }

  /** What this floor does not have goes back: perhaps it is in the queue by now. */
  private void wished(FloorMessage.Wished m) {
    OpenMission open = missions.get(m.task());
    if (open == null) {
      report();
      manager.tell(new ManagerMessage.Wished(m.task(), m.wish(), m.replyTo()));
      return;
    }
    Optional<Objection> objection = open.mission().objectionTo(m.wish());
    if (objection.isPresent()) {
      m.replyTo().tell(StatusReply.success(Answer.conflict(objection.get())));
      return;
    }
    Mission next = happened(open.mission(), m.wish());
    report();
    TaskView view = view(new OpenMission(next, clock.instant()));
    writer.write(
        () -> {}, () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(view))));
  }

  private void carryOut(Mission.Step step, MissionCommand command) {
    FloorRobot robot = robots.get(command.robot());
    if (robot == null) {
      return;
    }
    long task = step.mission().id();
    switch (command) {
      case MissionCommand.Drive drive -> {
        robot.errand = errand(step.mission(), drive.robot());
        robot.trouble = null;
        robot.notBefore = Instant.MIN;
      }
      case MissionCommand.Stop stop -> drop(robot, task);
      case MissionCommand.LetGo letGo -> drop(robot, task);
    }
    changed = true;
  }

  private static void drop(FloorRobot robot, long task) {
    if (robot.errand != null && Objects.equals(robot.errand.task(), task)) {
      robot.errand = null;
      robot.trouble = null;
    }
  }

  private Errand errand(Mission mission, String robot) {
    int phase = mission.carrier(robot).map(Carrier::phase).orElse(3);
    Vec2 goal =
        switch (phase) {
          case 1 -> mission.object().position();
          case 2 -> mission.destination().position();
          default -> home(robot).orElse(mission.task().goal().position());
        };
    return new Errand(mission.id(), phase, goal);
  }

  private Optional<Vec2> home(String robot) {
    return Optional.ofNullable(robots.get(robot))
        .map(r -> r.record.parking())
        .flatMap(floor::place)
        .map(Place::position);
  }

  // --- robots -----------------------------------------------------------------------------------

  private FloorRobot join(RobotRecord record) {
    ActorRef<RobotMessage> agent =
        getContext()
            .spawn(
                RobotAgent.of(record, getContext().getSelf(), store, links, now),
                "robot-" + robots.size());
    FloorRobot robot = new FloorRobot(record, agent, now);
    robots.put(record.name(), robot);
    changed = true;
    return robot;
  }

  private void locate(FloorMessage.Locate m) {
    m.replyTo().tell(StatusReply.success(located(m)));
  }

  private Answer<RobotView> located(FloorMessage.Locate m) {
    FloorRobot robot = robots.get(m.robot());
    if (robot == null) {
      return unknown(m.robot());
    }
    if (!robot.connected) {
      return new Answer.Refused<>(null, m.robot() + " is not connected; try again when it is.");
    }
    if (!floor.grid().isFree(m.pose().position())) {
      return new Answer.Refused<>(
          "x", "A robot cannot stand there: that is a wall or off the map.");
    }
    robot.agent.tell(new RobotMessage.Locate(m.pose()));
    note("robot.located", null, m.robot(), m.user(), m.user() + " said where " + m.robot() + " is");
    return new Answer.Accepted<>(view(robot));
  }

  private static Answer<RobotView> unknown(String robot) {
    return new Answer.Unknown<>("There is no robot " + robot + " on this floor.");
  }

  // --- holding and going home -------------------------------------------------------------------

  private void pause(@Nullable FleetPause next) {
    pause = next;
    changed = true;
    robots.values().forEach(this::holdOrGoOn);
  }

  private void hold(FloorMessage.HoldRobot m) {
    FloorRobot robot = robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(unknown(m.robot())));
      return;
    }
    List<EventRecord> events =
        robot.held == m.hold()
            ? List.of()
            : List.of(
                event(
                    robot,
                    m.hold() ? "robot.held" : "robot.resumed",
                    m.user(),
                    m.user()
                        + (m.hold()
                            ? " put " + m.robot() + " on hold"
                            : " let " + m.robot() + " go on")));
    robot.held = m.hold();
    holdOrGoOn(robot);
    report();
    RobotView view = view(robot);
    writer.write(
        () -> store.saveHold(m.robot(), m.hold(), events),
        () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(view))));
  }

  /** Tells the robot to hold or to go on, until it says that it does. */
  private void holdOrGoOn(FloorRobot robot) {
    String reason = holdReason(robot);
    changed |= !Objects.equals(reason, robot.holdReason);
    robot.holdReason = reason;
    boolean shall = reason != null;
    if (shall) {
      robot.lastHeld = now;
    }
    boolean does = robot.mode == Mode.ERROR ? robot.toldToHold : robot.mode == Mode.HOLDING;
    boolean isToldAlready =
        robot.toldToHold == shall && robot.toldToHoldAt.plus(RETRY_AFTER).isAfter(now);
    if (robot.isHeard() && shall != does && !isToldAlready) {
      robot.toldToHold = shall;
      robot.toldToHoldAt = now;
      robot.agent.tell(new RobotMessage.Hold(shall));
    }
  }

  private @Nullable String holdReason(FloorRobot robot) {
    if (pause != null) {
      return "All robots are paused by " + pause.user();
    }
    if (robot.held) {
      return "On hold by a person’s word";
    }
    return missionOf(robot.name())
        .filter(Mission::held)
        .map(mission -> "Task " + mission.id() + " is on hold")
        .orElse(null);
  }

  private void sendHome(FloorMessage.SendHome m) {
    FloorRobot robot = robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(unknown(m.robot())));
      return;
    }
    String objection = objectionToGoingHome(robot);
    if (objection != null) {
      m.replyTo().tell(StatusReply.success(new Answer.Conflict<>(objection, null)));
      return;
    }
    home(robot.name()).ifPresent(parking -> robot.errand = Errand.home(parking));
    EventRecord event =
        event(robot, "robot.sent-home", m.user(), m.user() + " sent " + m.robot() + " home");
    report();
    RobotView view = view(robot);
    writer.write(
        () -> store.addEvents(List.of(event)),
        () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(view))));
  }

  private @Nullable String objectionToGoingHome(FloorRobot robot) {
    Optional<Mission> mission = missionOf(robot.name());
    if (mission.isPresent()) {
      return robot.name() + " works for task " + mission.get().id() + "; it drives home after it.";
    }
    if (home(robot.name()).isEmpty()) {
      return robot.name() + " has no parking point, so it has no home.";
    }
    if (robot.holdReason != null) {
      return robot.name() + " is on hold; let it go on first.";
    }
    return robot.isFit()
        ? null
        : robot.name()
            + " cannot drive now: it is "
            + robot.state().name().toLowerCase(Locale.ROOT).replace('_', ' ')
            + ".";
  }

  /** Parking when idle. */
  private void sendHomeWhenIdle(FloorRobot robot) {
    boolean isIdle =
        robot.errand == null
            && robot.isStanding()
            && robot.isFit()
            && robot.holdReason == null
            && missionOf(robot.name()).isEmpty();
    if (!isIdle) {
      robot.idleSince = null;
    } else if (robot.idleSince == null) {
      robot.idleSince = now;
    } else if (!robot.idleSince.plus(HOME_AFTER).isAfter(now)) {
      home(robot.name())
          .filter(parking -> !isAt(robot, parking))
          .ifPresent(parking -> robot.errand = Errand.home(parking));
    }
  }

  private boolean isAt(FloorRobot robot, Vec2 place) {
    Pose pose = robot.pose;
    return pose != null
        && (pose.position().distanceTo(place) < ARRIVED
            || floor.grid().cellAt(pose.position()).equals(floor.grid().cellAt(place)));
  }

  private EventRecord event(FloorRobot robot, String kind, String user, String text) {
    Long task = missionOf(robot.name()).map(Mission::id).orElse(null);
    return new EventRecord(clock.instant(), kind, task, robot.name(), user, text);
  }

  // --- service ----------------------------------------------------------------------------------

  private void serve(FloorMessage.Serve m) {
    FloorRobot robot = robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(unknown(m.robot())));
      return;
    }
    boolean clears = !m.inService() && isKept(robot);
    if (robot.inService == m.inService() && !clears) {
      m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(view(robot))));
      return;
    }
    EventRecord event =
        event(
            robot,
            m.inService() ? "robot.in-service" : "robot.out-of-service",
            m.user(),
            sentence(m, clears));
    ActorRef<FloorMessage> self = getContext().getSelf();
    writer.tryOnce(
        () -> store.saveService(m.robot(), m.inService(), List.of(event)),
        () -> self.tell(new FloorMessage.ServiceStored(m, clears)),
        failure -> m.replyTo().tell(StatusReply.error(failure)));
  }

  private static String sentence(FloorMessage.Serve m, boolean clears) {
    if (m.inService()) {
      return m.user() + " put " + m.robot() + " back in service";
    }
    return m.user()
        + " took "
        + m.robot()
        + " out of service"
        + (clears ? "; it does not stand any more where it was lost" : "");
  }

  private void serviceStored(FloorMessage.Serve m, boolean clears) {
    FloorRobot robot = robots.get(m.robot());
    if (robot == null) {
      return;
    }
    robot.inService = m.inService();
    watch(robot); // while its place is known
    if (clears && isKept(robot)) {
      traffic.leaves(robot.name());
      robot.pose = null;
      robot.driveUnderway = false;
    }
    report();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(view(robot))));
  }

  /** Whether its cells stay reserved though nothing is heard from it. */
  private boolean isKept(FloorRobot robot) {
    return !robot.isHeard() && traffic.knows(robot.name());
  }

  // --- what robots say --------------------------------------------------------------------------

  private void fromRobot(FloorMessage.FromRobot message) {
    FloorRobot robot = robots.get(message.robot());
    if (robot == null) {
      return;
    }
    changed = true;
    switch (message) {
      case FloorMessage.Connected m -> connected(robot, m.hello(), m.drive());
      case FloorMessage.Disconnected m -> {
        fallsSilent(robot);
        robot.connected = false;
      }
      case FloorMessage.Silent m -> {
        fallsSilent(robot);
        robot.silent = true;
      }
      case FloorMessage.HeardAgain m -> {
        robot.silent = false;
        disown(robot);
      }
      case FloorMessage.Heard m -> heard(robot, m.state());
      case FloorMessage.PhaseEnded m -> phaseEnded(robot, m.end());
      case FloorMessage.DriveBegun m -> driveBegun(robot, m.drive());
      case FloorMessage.DriveTaken m -> driveTaken(robot, m.drive());
      case FloorMessage.Rejected m -> rejected(robot, m.reason());
    }
  }

  private void fallsSilent(FloorRobot robot) {
    if (robot.isHeard()) {
      robot.quietSince = now;
    }
  }

  /** A robot that comes back with a task that it has no more is sent {@code cancel} first. */
  private void disown(FloorRobot robot) {
    Long task = robot.reportedTask;
    if (task != null && missionOf(robot.name()).filter(m -> m.id() == task).isEmpty()) {
      cancel(robot);
    }
  }

  /** Compares what the robot says with what was stored, and goes on from there. */
  private void connected(FloorRobot robot, Hello hello, Optional<StoredDrive> stored) {
    robot.hear(hello, clock.instant());
    robot.driveUnderway = false;
    robot.cancelling = false;
    robot.toldToHold = false;
    robot.toldToHoldAt = Instant.MIN;
    robot.told = stored.filter(d -> d.seq() == hello.drive()).orElse(null);
    if (robot.told != null) {
      isOnItsWay(robot, robot.told, hello.pose(), hello.segment(), hello.released());
    } else {
      traffic.stands(robot.name(), hello.pose(), hello.footprint(), now);
    }
    traffic.drivesAt(robot.name(), DriveSpeeds.DEFAULT.atMost(hello.maxSpeed()));
    if (hello.done() != null) {
      phaseEnded(robot, hello.done());
    }
    disown(robot);
    holdOrGoOn(robot);
  }

  private void heard(FloorRobot robot, AgentMessage.State state) {
    robot.hear(state, clock.instant());
    if (robot.told != null && state.drive() == robot.told.seq()) {
      robot.driveUnderway = false;
      if (traffic.knows(robot.name())) {
        traffic.moved(robot.name(), state.pose(), state.segment(), now);
      } else {
        isOnItsWay(robot, robot.told, state.pose(), state.segment(), state.released());
      }
    } else if (!robot.driveUnderway && !isBraking(robot)) {
      if (state.drive() == 0) {
        robot.told = null;
        robot.cancelling = false;
      }
      traffic.stands(robot.name(), state.pose(), robot.footprint, now);
    }
    if (state.localised()) {
      record(watch.see(robot.name(), state.obstacles(), robots.keySet(), now));
    }
  }

  private static boolean isBraking(FloorRobot robot) {
    return robot.mode == Mode.DRIVING || (robot.mode == Mode.HOLDING && robot.moving);
  }

  private void isOnItsWay(
      FloorRobot robot, StoredDrive drive, Pose pose, int segment, int released) {
    traffic.drives(robot.name(), pose, robot.footprint, drive.way(), segment, released, now);
  }

  private void phaseEnded(FloorRobot robot, PhaseEnd end) {
    OpenMission open = end.task() == null ? null : missions.get(end.task());
    if (open != null
        && (end.phase() == 3 || isAt(robot, errand(open.mission(), robot.name()).goal()))) {
      happened(open.mission(), new MissionEvent.PhaseEnded(robot.name(), end.phase()));
    } // else its way was changed meanwhile, or the task has ended
    // written in order: acknowledged only when what follows from the flag is safe
    writer.write(() -> {}, () -> robot.agent.tell(new RobotMessage.Acknowledge(end.drive())));
  }

  private void driveBegun(FloorRobot robot, StoredDrive drive) {
    robot.told = drive;
    if (drive.task() != null) {
      happened(drive.task(), new MissionEvent.DriveStarted(robot.name(), drive.phase()));
    }
  }

  /** A drive may be so short that no state of the robot ever tells of it. */
  private static void driveTaken(FloorRobot robot, long drive) {
    if (robot.told != null && robot.told.seq() == drive) {
      robot.driveUnderway = false;
      robot.drive = drive;
    }
  }

  /** What the robot refused is given up: it stands, and is asked anew a little later. */
  private void rejected(FloorRobot robot, String reason) {
    robot.driveUnderway = false;
    robot.cancelling = false;
    robot.trouble = robot.name() + " refused a command: " + reason;
    robot.notBefore = now.plus(RETRY_AFTER);
    if (robot.drive != 0) {
      cancel(robot);
    } else if (robot.pose != null) {
      robot.told = null;
      traffic.stands(robot.name(), robot.pose, robot.footprint, now);
    }
  }

  // --- ways -------------------------------------------------------------------------------------

  /** Tells the traffic what is so and wanted, and the robots what it decides. */
  private void drive() {
    for (FloorRobot robot : robots.values()) {
      watch(robot);
      holdOrGoOn(robot);
      sendHomeWhenIdle(robot);
      if (traffic.knows(robot.name())) {
        direct(robot);
      }
    }
    record(watch.tellObstacles(now));
    for (Decision decision : traffic.decide(now)) {
      FloorRobot robot = robots.get(decision.robot());
      if (robot != null) {
        tell(robot, decision);
        changed = true;
      }
    }
    record(watch.askStandstills(this::isHeldLately));
  }

  /** Tells the robot's mission what it must know of the robot. */
  private void watch(FloorRobot robot) {
    Optional<Mission> mission = missionOf(robot.name());
    if (mission.isEmpty()) {
      return;
    }
    robotWatch.look(robot, now).ifPresent(event -> happened(mission.get(), event));
    if (mission.get().isStopping() && robot.errand == null && robot.hasStopped()) {
      TaskPlace place = RobotWatch.place(robot);
      if (place != null) {
        happened(mission.get().id(), new MissionEvent.Stopped(robot.name(), place));
      }
    }
  }

  /** A robot on hold does not get on, and needs a while when it goes on. */
  private boolean isHeldLately(String name) {
    FloorRobot robot = robots.get(name);
    return robot != null && robot.lastHeld.plus(STARTS_WITHIN).isAfter(now);
  }

  private void record(List<Remark> remarks) {
    for (Remark remark : remarks) {
      changed = true;
      Long task = missionOf(remark.robot()).map(Mission::id).orElse(null);
      note(remark.kind(), task, remark.robot(), EventRecord.SYSTEM, remark.text());
    }
  }

  private void direct(FloorRobot robot) {
    Errand errand = robot.duty();
    boolean isOnOtherWay = !robot.isStanding() && (errand == null || !robot.isOnTheWayOf(errand));
    boolean mayEnd = robot.told != null && robot.told.task() == null && robot.toldGoal == null;
    boolean isStray = isOnOtherWay && !(robot.inService && mayEnd);
    if (isStray && !robot.driveUnderway && robot.drive != 0) {
      cancel(robot);
    }
    boolean isWaiting = robot.notBefore.isAfter(now);
    traffic.isFixed(
        robot.name(), !robot.isFit() || robot.holdReason != null || isStray || isWaiting);
    traffic.wants(robot.name(), errand == null || isOnOtherWay ? null : errand.goal(), now);
    if (errand != null && robot.isStanding() && robot.isFit() && traffic.isAtGoal(robot.name())) {
      arrived(robot, errand);
    }
    if (!isWaiting) {
      note(robot, errand == null ? null : traffic.reason(robot.name()));
    }
  }

  private void arrived(FloorRobot robot, Errand errand) {
    if (errand.task() == null) {
      robot.errand = null;
      changed = true;
    } else {
      happened(errand.task(), new MissionEvent.PhaseEnded(robot.name(), errand.phase()));
    }
  }

  private void note(FloorRobot robot, @Nullable String reason) {
    if (!Objects.equals(robot.trouble, reason)) {
      robot.trouble = reason;
      changed = true;
    }
  }

  private static void tell(FloorRobot robot, Decision decision) {
    switch (decision) {
      case Decision.Begin begin -> {
        Errand errand = robot.errand;
        robot.driveUnderway = true;
        robot.toldGoal = errand == null ? null : errand.goal();
        robot.agent.tell(
            new RobotMessage.Drive(
                errand == null ? null : errand.task(),
                errand == null ? 0 : errand.phase(),
                begin.way(),
                begin.released(),
                begin.last()));
      }
      case Decision.Extend extend ->
          robot.agent.tell(
              new RobotMessage.Extend(
                  extend.from(), extend.segments(), extend.released(), extend.last()));
      case Decision.Release release ->
          robot.agent.tell(new RobotMessage.Release(release.released()));
    }
  }

  /** Ends a drive that nobody wants any more: as when a returning robot is needed elsewhere. */
  private void cancel(FloorRobot robot) {
    if (robot.connected && !robot.cancelling) {
      robot.cancelling = true;
      log.info("{}: its drive {} is not wanted any more.", robot.name(), robot.drive);
      robot.agent.tell(new RobotMessage.Cancel(robot.reportedTask));
    }
  }

  // --- time and reports -------------------------------------------------------------------------

  private void tick(Instant time) {
    now = time;
    robots.values().forEach(r -> r.agent.tell(new RobotMessage.Tick(now)));
    drive();
    if (changed) {
      report();
    }
  }

  private void report() {
    changed = false;
    List<String> alerts = writer.trouble() == null ? List.of() : List.of(StoreWatch.AWAY);
    manager.tell(
        new ManagerMessage.FloorReport(
            view(),
            robots.values().stream().map(r -> view(r)).toList(),
            missions.values().stream().map(this::view).toList(),
            List.copyOf(ended),
            alerts));
    ended.clear();
  }

  private FloorView view() {
    Map<String, CellRuns> kept = new TreeMap<>();
    robots.values().stream()
        .filter(this::isKept)
        .forEach(r -> kept.put(r.name(), CellRuns.of(traffic.held(r.name()))));
    return watch.view(kept);
  }

  private RobotView view(FloorRobot robot) {
    Route route = traffic.knows(robot.name()) ? traffic.route(robot.name()) : Route.NONE;
    Errand work = missionOf(robot.name()).map(m -> errand(m, robot.name())).orElse(robot.errand);
    return robot.view(floor.name(), work, route);
  }

  private TaskView view(OpenMission open) {
    Mission mission = open.mission();
    return TaskView.of(
        mission, mission.state().isEnded() ? null : waitingFor(mission), open.changedAt());
  }

  private @Nullable String waitingFor(Mission mission) {
    List<String> reasons = new ArrayList<>();
    for (Carrier c : mission.carriers()) {
      FloorRobot robot = robots.get(c.robot());
      if (c.released() || robot == null) {
        continue;
      }
      switch (robot.state()) {
        case CONNECTING, LOST -> reasons.add(robot.name() + " is not connected");
        case NOT_LOCALISED ->
            reasons.add(robot.name() + " does not know where it is: say it on the robot's page");
        case ERROR -> reasons.add(robot.name() + " reports an error");
        case OUT_OF_SERVICE ->
            reasons.add(robot.name() + " is out of service: put it back in service");
        case IDLE, DRIVING, HOLDING -> {
          if (robot.holdReason != null) {
            reasons.add(robot.holdReason);
          } else if (robot.trouble != null) {
            reasons.add(robot.trouble);
          }
        }
      }
    }
    return reasons.isEmpty() ? null : String.join("; ", reasons);
  }

  private void note(
      String kind, @Nullable Long task, @Nullable String robot, String who, String text) {
    EventRecord event = new EventRecord(clock.instant(), kind, task, robot, who, text);
    writer.write(() -> store.addEvents(List.of(event)), () -> {});
  }

  private Behavior<FloorMessage> closed() {
    writer.close();
    return this;
  }
}
