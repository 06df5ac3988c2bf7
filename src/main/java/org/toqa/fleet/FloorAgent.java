package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.PostStop;
import org.apache.pekko.actor.typed.javadsl.AbstractBehavior;
import org.apache.pekko.actor.typed.javadsl.ActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.apache.pekko.actor.typed.javadsl.Receive;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.FloorRobot.Errand;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.link.RobotLinks;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.mission.Carrier;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionCommand;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;

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

  private final FloorMap floor;
  private final FleetStore store;
  private final RobotLinks links;
  private final InstantSource clock;
  private final ActorRef<ManagerMessage> manager;
  private final StoreWriter writer;
  private final WayPlanner planner;

  private final Map<String, FloorRobot> robots = new TreeMap<>();
  private final Map<Long, OpenMission> missions = new LinkedHashMap<>();
  private final List<TaskView> ended = new ArrayList<>();
  private Instant now;
  private boolean changed = true;

  /** A mission, and when it last changed. */
  private record OpenMission(Mission mission, Instant changedAt) {}

  static Behavior<FloorMessage> of(
      FloorMap floor,
      List<RobotRecord> robots,
      List<OpenTask> begun,
      FleetStore store,
      RobotLinks links,
      InstantSource clock,
      Instant now,
      ActorRef<ManagerMessage> manager) {
    return Behaviors.setup(
        context ->
            new FloorAgent(context, floor, robots, begun, store, links, clock, now, manager));
  }

  private FloorAgent(
      ActorContext<FloorMessage> context,
      FloorMap floor,
      List<RobotRecord> records,
      List<OpenTask> begun,
      FleetStore store,
      RobotLinks links,
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
    this.planner = new WayPlanner(floor.grid());
    records.forEach(this::join);
    begun.forEach(this::recover);
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
      case FloorMessage.RobotJoined m -> join(m.robot());
      case FloorMessage.Locate m -> locate(m);
      case FloorMessage.Stored m -> m.step().commands().forEach(c -> carryOut(m.step(), c));
      case FloorMessage.Tick m -> tick(m.now());
      case FloorMessage.FromRobot m -> fromRobot(m);
    }
    return this;
  }

  // --- missions ---------------------------------------------------------------------------------

  private void begin(FloorMessage.Begin m) {
    for (String name : m.robots()) {
      missionOf(name)
          .ifPresent(old -> apply(old.on(new MissionEvent.Retasked(name)), "task.retasked", name));
    }
    apply(Mission.assign(m.task(), m.robots(), m.why()), "task.assigned", null);
    manager.tell(new ManagerMessage.Begun(m.task().id()));
    report();
  }

  /** A mission that was under way when the server stopped goes on in the phase it was stored in. */
  private void recover(OpenTask open) {
    Mission mission = new Mission(open.task(), open.state(), open.carriers());
    missions.put(mission.id(), new OpenMission(mission, open.changedAt()));
    for (Carrier c : mission.carriers()) {
      FloorRobot robot = robots.get(c.robot());
      if (c.isDriving() && robot != null) {
        robot.errand = errand(mission, c.robot(), c.phase());
      }
    }
  }

  private Optional<Mission> missionOf(String robot) {
    return missions.values().stream()
        .map(OpenMission::mission)
        .filter(m -> m.carrier(robot).filter(c -> !c.released()).isPresent())
        .findFirst();
  }

  private void handle(long task, MissionEvent event, String kind) {
    OpenMission open = missions.get(task);
    if (open != null) {
      apply(open.mission().on(event), kind, event.robot());
    }
  }

  /** Stores the step; its commands are carried out when it is safe. */
  private void apply(Mission.Step step, String kind, @Nullable String robot) {
    if (!step.changed()) {
      return;
    }
    Mission mission = step.mission();
    Instant at = clock.instant();
    if (mission.state().isEnded()) {
      missions.remove(mission.id());
      ended.add(view(new OpenMission(mission, at)));
    } else {
      missions.put(mission.id(), new OpenMission(mission, at));
    }
    changed = true;
    List<EventRecord> events =
        step.history().stream()
            .map(text -> new EventRecord(at, kind, mission.id(), robot, EventRecord.SYSTEM, text))
            .toList();
    ActorRef<FloorMessage> self = getContext().getSelf();
    writer.write(
        () -> store.saveMission(mission, at, events),
        () -> self.tell(new FloorMessage.Stored(step)));
  }

  private void carryOut(Mission.Step step, MissionCommand command) {
    FloorRobot robot = robots.get(command.robot());
    if (robot == null) {
      return;
    }
    long task = step.mission().id();
    switch (command) {
      case MissionCommand.Drive drive -> {
        robot.errand = errand(step.mission(), drive.robot(), drive.phase());
        robot.trouble = null;
        robot.notBefore = Instant.MIN;
      }
      case MissionCommand.LetGo letGo -> {
        if (robot.errand != null && robot.errand.task() == task) {
          robot.errand = null;
          robot.trouble = null;
        }
      }
    }
    changed = true;
    dispatch(robot);
  }

  private Errand errand(Mission mission, String robot, int phase) {
    TransportTask task = mission.task();
    Vec2 goal =
        switch (phase) {
          case 1 -> task.start().position();
          case 2 -> task.goal().position();
          default -> home(robot).orElse(task.goal().position());
        };
    return new Errand(task.id(), phase, goal);
  }

  private Optional<Vec2> home(String robot) {
    return Optional.ofNullable(robots.get(robot))
        .map(r -> r.record.parking())
        .flatMap(floor::place)
        .map(Place::position);
  }

  // --- robots -----------------------------------------------------------------------------------

  private void join(RobotRecord record) {
    ActorRef<RobotMessage> agent =
        getContext()
            .spawn(
                RobotAgent.of(record, getContext().getSelf(), store, links, now),
                "robot-" + robots.size());
    robots.put(record.name(), new FloorRobot(record, agent));
    changed = true;
  }

  private void locate(FloorMessage.Locate m) {
    FloorRobot robot = robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(new Answer.Unknown<>("There is no robot " + m.robot() + " on this floor."));
    } else if (!robot.connected) {
      m.replyTo()
          .tell(new Answer.Refused<>(null, m.robot() + " is not connected; try again when it is."));
    } else if (!floor.grid().isFree(m.pose().position())) {
      m.replyTo()
          .tell(
              new Answer.Refused<>(
                  "x", "A robot cannot stand there: that is a wall or off the map."));
    } else {
      robot.agent.tell(new RobotMessage.Locate(m.pose()));
      note(
          "robot.located",
          null,
          m.robot(),
          m.user(),
          m.user() + " said where " + m.robot() + " is");
      m.replyTo().tell(new Answer.Accepted<>(robot.view(floor.name())));
    }
  }

  private void fromRobot(FloorMessage.FromRobot message) {
    FloorRobot robot = robots.get(message.robot());
    if (robot == null) {
      return;
    }
    changed = true;
    switch (message) {
      case FloorMessage.Connected m -> connected(robot, m.hello(), m.drive());
      case FloorMessage.Disconnected m -> robot.connected = false;
      case FloorMessage.Silent m -> robot.silent = true;
      case FloorMessage.HeardAgain m -> robot.silent = false;
      case FloorMessage.Heard m -> robot.hear(m.state(), clock.instant());
      case FloorMessage.PhaseEnded m -> phaseEnded(robot, m.end());
      case FloorMessage.DriveSent m -> driveSent(robot, m.drive());
      case FloorMessage.Rejected m -> rejected(robot, m.reason());
    }
    dispatch(robot);
  }

  /** Compares what the robot says with what was stored, and goes on from there. */
  private void connected(FloorRobot robot, Hello hello, Optional<StoredDrive> stored) {
    robot.hear(hello, clock.instant());
    robot.driveUnderway = false;
    robot.cancelling = false;
    robot.way =
        stored
            .filter(d -> d.seq() == hello.drive())
            .map(d -> Way.of(d, floor.grid(), hello.footprint()))
            .orElse(null);
    if (hello.done() != null) {
      phaseEnded(robot, hello.done());
    }
  }

  private void phaseEnded(FloorRobot robot, PhaseEnd end) {
    if (end.task() != null) {
      handle(end.task(), new MissionEvent.PhaseEnded(robot.name(), end.phase()), kind(end.phase()));
    }
    // written in order: acknowledged only when what follows from the flag is safe
    writer.write(() -> {}, () -> robot.agent.tell(new RobotMessage.Acknowledge(end.drive())));
  }

  private static String kind(int phase) {
    return switch (phase) {
      case 1 -> "task.at-object";
      case 2 -> "task.delivered";
      default -> "task.parked";
    };
  }

  private void driveSent(FloorRobot robot, StoredDrive drive) {
    robot.way = Way.of(drive, floor.grid(), robot.footprint);
    if (drive.task() != null) {
      handle(
          drive.task(), new MissionEvent.DriveStarted(robot.name(), drive.phase()), "task.started");
    }
  }

  private void rejected(FloorRobot robot, String reason) {
    if (robot.driveUnderway) {
      robot.driveUnderway = false;
      robot.way = null;
    }
    robot.cancelling = false;
    robot.trouble = robot.name() + " refused its way: " + reason;
    robot.notBefore = now.plus(RETRY_AFTER);
  }

  // --- ways -------------------------------------------------------------------------------------

  /** Sees to it that the robot is on the way of its errand, as far as that can be done now. */
  private void dispatch(FloorRobot robot) {
    if (robot.driveUnderway && robot.way != null && robot.drive == robot.way.drive().seq()) {
      robot.driveUnderway = false; // it has set out
    }
    if (robot.drive == 0) {
      robot.cancelling = false;
      if (!robot.driveUnderway) {
        robot.way = null;
      }
    }
    Errand errand = robot.errand;
    if (robot.drive != 0 && (errand == null || !robot.isOnTheWayOf(errand))) {
      cancelStrayDrive(robot);
      return;
    }
    Pose pose = robot.pose;
    if (errand == null || pose == null || !robot.isReady() || robot.notBefore.isAfter(now)) {
      return;
    }
    if (floor.grid().cellAt(pose.position()).equals(floor.grid().cellAt(errand.goal()))) {
      robot.trouble = null;
      handle(
          errand.task(),
          new MissionEvent.PhaseEnded(robot.name(), errand.phase()),
          kind(errand.phase()));
      return;
    }
    switch (planner.plan(pose, errand.goal(), robot.footprint, others(robot))) {
      case WayPlanner.Found found -> {
        robot.trouble = null;
        robot.driveUnderway = true;
        // reserved from now on, before it is stored and sent
        robot.way =
            Way.of(
                new StoredDrive(0, errand.task(), errand.phase(), found.way()),
                floor.grid(),
                robot.footprint);
        robot.agent.tell(new RobotMessage.Drive(errand.task(), errand.phase(), found.way()));
      }
      case WayPlanner.None none -> {
        robot.trouble = none.sentence();
        robot.notBefore = now.plus(RETRY_AFTER);
      }
    }
    changed = true;
  }

  /**
   * A drive that nobody wants any more: as after a restart, or when a returning robot is needed.
   */
  private void cancelStrayDrive(FloorRobot robot) {
    if (!robot.connected || robot.cancelling || robot.driveUnderway) {
      return;
    }
    robot.cancelling = true;
    Long task = robot.way == null ? null : robot.way.drive().task();
    log.info("{}: its drive {} is not wanted any more.", robot.name(), robot.drive);
    robot.agent.tell(new RobotMessage.Cancel(task));
  }

  private List<WayPlanner.Other> others(FloorRobot robot) {
    List<WayPlanner.Other> others = new ArrayList<>();
    for (FloorRobot other : robots.values()) {
      if (other != robot && other.pose != null) {
        BitSet reserved =
            other.way == null
                ? new BitSet()
                : other.way.cellsFrom(other.driveUnderway ? 0 : other.segment);
        reserved.or(
            org.toqa.traffic.SweptCells.standing(
                floor.grid(), other.pose.position(), other.footprint / 2));
        others.add(
            new WayPlanner.Other(
                other.name(), other.pose.position(), other.footprint, other.way != null, reserved));
      }
    }
    return others;
  }

  // --- time and reports -------------------------------------------------------------------------

  private void tick(Instant time) {
    now = time;
    robots.values().forEach(r -> r.agent.tell(new RobotMessage.Tick(now)));
    robots.values().forEach(this::dispatch);
    if (changed) {
      report();
    }
  }

  private void report() {
    changed = false;
    List<String> alerts =
        writer.trouble() == null
            ? List.of()
            : List.of("The database does not answer: " + writer.trouble());
    manager.tell(
        new ManagerMessage.FloorReport(
            floor.name(),
            robots.values().stream().map(r -> r.view(floor.name())).toList(),
            missions.values().stream().map(this::view).toList(),
            List.copyOf(ended),
            alerts));
    ended.clear();
  }

  private TaskView view(OpenMission open) {
    Mission mission = open.mission();
    return new TaskView(
        mission.task(),
        mission.state(),
        false,
        mission.robots(),
        mission.state() == TaskState.DONE ? null : waitingFor(mission),
        null,
        open.changedAt());
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
        case IDLE, DRIVING, HOLDING -> {
          if (robot.trouble != null) {
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
