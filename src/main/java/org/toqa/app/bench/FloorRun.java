package org.toqa.app.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.Chassis;
import org.toqa.app.bench.meter.ContactMeter;
import org.toqa.app.bench.meter.ProcessorTime;
import org.toqa.app.bench.meter.WaitMeter;
import org.toqa.fleet.ChargingRules;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.dispatch.FloorSystem;
import org.toqa.fleet.floor.FloorEvent;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.PairingCode;
import org.toqa.mission.Mission;
import org.toqa.motion.DriveSpeeds;
import org.toqa.statistics.Percentiles;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.GridPose;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * A floor's own agents over simulated robots and links, in simulated time and on one thread: each
 * tick of the robots, 20 ms, brings what is due, moves the bodies and looks at where they really
 * are; each fifth one is a tick of the floor.
 */
final class FloorRun implements AutoCloseable {
  private static final long ROBOT_TICK = Chassis.TICK.toNanos();
  private static final long FLOOR_TICK = Duration.ofMillis(100).toNanos();
  private static final Duration REASSIGN_AFTER = Duration.ofSeconds(30);

  /** By then all robots are connected, and their tasks begin; nanoseconds of simulated time. */
  private static final long CONNECTED = Duration.ofSeconds(1).toNanos();

  private static final Duration NEXT_TRY = Duration.ofMillis(100);

  /** The reports of robots are spread over this many of their ticks. */
  private static final int REPORT_TICKS = 10;

  private final OccupancyGrid grid;
  private final SteppedRuntime runtime;
  private final Duration linkDelay;
  private final FloorSystem floor;
  private final GoalDispatcher dispatcher;
  private final WaitMeter waits;
  private final ContactMeter contacts;
  private final List<DrivenRobot> robots = new ArrayList<>();
  private final RobotLink.@Nullable Listener[] servers;
  private final List<Double> tickMillis = new ArrayList<>();
  private long realNanos;
  private double processorMillis;
  private long robotNanos;

  /**
   * What is simulated.
   *
   * @param poseError metres that a body is beside where its robot takes itself to be, at most
   * @param store until a change is stored
   * @param link until a message is at the other end
   * @param planning until a plan is ready
   * @param look of {@link SteppedRuntime}
   */
  record World(
      FloorMap map,
      Workload work,
      double poseError,
      Duration store,
      Duration link,
      Duration planning,
      Duration look,
      long seed) {

    /** Robots of the usual size, or smaller ones where cells are smaller. */
    double diameter() {
      return Math.min(0.255, 0.85 * map.grid().resolution());
    }
  }

  /**
   * What was reached; times beside seconds are real time.
   *
   * @param goals visited cells, of all robots together
   * @param goalsPerStep a step being what a robot takes to the next cell, stepSeconds
   * @param planP50Ms planning several robots together, once
   * @param tickP50Ms the longest turn of an agent at a tick, which is that of the floor's
   * @param longestWaitSeconds in which a robot stood short of its goal
   * @param longestWaitReason what the floor said then; null: nothing
   * @param longestUnnamedWaitSeconds in which it stood and the floor did not say why
   * @param contacts how often two bodies came to touch
   * @param nearestMetres between the edges of two bodies; null: none came within 2 m
   * @param nearestWallMetres between the edges of a body and of a wall, likewise
   * @param metres of all robots together
   * @param speed simulated seconds a real second
   * @param processorSeconds of the one thread that does it all
   * @param agentSeconds real time that all agents took
   * @param planSeconds real time that planning several robots together took
   * @param robotSeconds real time that the simulated robots took
   */
  record Report(
      int goals,
      double goalsPerSecond,
      double goalsPerStep,
      double stepSeconds,
      int plans,
      double planP50Ms,
      double planP99Ms,
      double planMaxMs,
      double tickP50Ms,
      double tickP99Ms,
      double tickMaxMs,
      double longestWaitSeconds,
      String longestWaitRobot,
      @Nullable String longestWaitReason,
      double longestUnnamedWaitSeconds,
      int contacts,
      int wallContacts,
      @Nullable Double nearestMetres,
      @Nullable Double nearestWallMetres,
      double metres,
      double diameter,
      double seconds,
      double speed,
      double processorSeconds,
      double agentSeconds,
      double planSeconds,
      double robotSeconds) {}

  FloorRun(World world) {
    grid = world.map().grid();
    runtime = new SteppedRuntime(world.store(), world.planning(), world.look());
    linkDelay = world.link();
    List<GridPose> starts = world.work().starts();
    servers = new RobotLink.Listener[starts.size()];
    contacts = new ContactMeter(grid, starts.size(), world.diameter() / 2);
    for (int i = 0; i < starts.size(); i++) {
      addRobot(i, starts.get(i), world);
    }
    waits = new WaitMeter(robots.stream().map(DrivenRobot::truePosition).toArray(Vec2[]::new));
    dispatcher =
        new GoalDispatcher(
            world.work().goals(),
            starts.stream().map(GridPose::cell).toList(),
            grid::centre,
            world.map().name(),
            runtime.instant(),
            new GoalListener());
    List<RobotRecord> records =
        IntStream.range(0, starts.size())
            .mapToObj(i -> record(robots.get(i).name(), i, world.map().name()))
            .toList();
    floor =
        runtime.await(
            () ->
                new FloorSystem(
                    world.map(),
                    records,
                    new ForgetfulStore(),
                    new Links(),
                    new FleetRules(REASSIGN_AFTER, ChargingRules.USUAL, 1),
                    runtime,
                    runtime.instant(),
                    runtime,
                    this::told));
    runtime.runAgents();
    while (runtime.nanos() < CONNECTED) {
      step();
    }
    runtime.resetMeasurements();
    tickMillis.clear();
    robotNanos = 0;
    dispatcher.begin();
    runtime.runAgents();
  }

  private void addRobot(int index, GridPose start, World world) {
    Vec2 at = grid.centre(start.cell());
    DrivenRobot robot =
        new DrivenRobot(
            "r" + (index + 1),
            new Pose(at.x(), at.y(), start.heading().angle()),
            world.diameter(),
            new PoseError(world.poseError(), world.seed() * 1_000_003 + index),
            message ->
                runtime.schedule(
                    linkDelay,
                    () -> {
                      RobotLink.Listener server = servers[index];
                      if (server != null) {
                        server.received(message);
                      }
                    }));
    robots.add(robot);
    contacts.place(index, robot.truePosition());
  }

  /** The port is its index, by which its link finds it. */
  private static RobotRecord record(String name, int index, String floor) {
    return RobotRecord.direct(name, floor, "simulated", index, 5, null, true, null);
  }

  private final class Links implements RobotLinkFactory {
    @Override
    public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
      int index = address.port();
      DrivenRobot robot = robots.get(index);
      Duration start = Chassis.TICK.multipliedBy(index % REPORT_TICKS);
      runtime.schedule(
          linkDelay.plus(start),
          () -> {
            servers[index] = listener;
            listener.connected(robot.hello());
          });
      return new RobotLink() {
        @Override
        public void send(ServerMessage message) {
          runtime.schedule(linkDelay, () -> robot.receive(message));
        }

        @Override
        public void close() {
          servers[index] = null;
        }
      };
    }

    @Override
    public PairingResult pair(RobotAddress robot, PairingCode code) {
      return new PairingResult.Unreachable(Sentence.verbatim("It is simulated."));
    }
  }

  private final class GoalListener implements GoalDispatcher.Listener {
    @Override
    public void taskMade(int robot, Mission mission) {
      floor.beginTask(mission, robots.get(robot).name(), Phrase.NEAREST_FREE.with());
    }

    @Override
    public void goalChanged(int robot) {
      waits.setGoal(robot, runtime.nanos());
    }

    @Override
    public void waits(int robot, @Nullable String reason) {
      waits.setReason(robot, reason);
    }
  }

  private void told(FloorEvent event) {
    switch (event) {
      case FloorEvent.FloorReport report -> {
        report.missions().forEach(dispatcher::update);
        report.ended().forEach(dispatcher::update);
      }
      case FloorEvent.TaskNotBegun(Mission mission) ->
          runtime.schedule(NEXT_TRY, () -> dispatcher.repeat(mission));
      default -> {}
    }
  }

  /**
   * Lets simulated time go on.
   *
   * @param end when it ends before that, in real time
   */
  void run(Duration time, Deadline end) {
    long begin = System.nanoTime();
    double processorBegin = ProcessorTime.millis();
    for (long last = runtime.nanos() + time.toNanos();
        runtime.nanos() < last && !end.isPassed(); ) {
      step();
    }
    realNanos += System.nanoTime() - begin;
    processorMillis += ProcessorTime.millis() - processorBegin;
  }

  private void step() {
    long now = runtime.nanos() + ROBOT_TICK;
    runtime.advanceTo(now);
    long begin = System.nanoTime();
    List<Integer> moved = new ArrayList<>();
    for (int i = 0; i < robots.size(); i++) {
      DrivenRobot robot = robots.get(i);
      boolean moves = servers[i] != null && robot.tick(now);
      if (moves || now == ROBOT_TICK) {
        contacts.place(i, robot.truePosition());
        moved.add(i);
      }
      if (now % FLOOR_TICK == 0) {
        waits.observe(i, robot.truePosition(), now);
      }
    }
    moved.forEach(contacts::judge);
    robotNanos += System.nanoTime() - begin;
    if (now % FLOOR_TICK == 0) {
      floor.tick(runtime.instant());
      tickMillis.add(runtime.runAgents() / 1e6);
    }
  }

  /** What the agents failed at, in sentences. */
  List<String> failures() {
    return floor.failures().stream().map(Sentence::english).toList();
  }

  Report report() {
    double seconds = (runtime.nanos() - CONNECTED) / 1e9;
    double stepSeconds = grid.resolution() / DriveSpeeds.DEFAULT.forward();
    double[] plans = runtime.planMillis();
    Percentiles planTimes = new Percentiles(plans);
    Percentiles ticks =
        new Percentiles(tickMillis.stream().mapToDouble(Double::doubleValue).toArray());
    return new Report(
        dispatcher.goals(),
        dispatcher.goals() / seconds,
        dispatcher.goals() / seconds * stepSeconds,
        stepSeconds,
        plans.length,
        planTimes.percentile(0.50),
        planTimes.percentile(0.99),
        planTimes.max(),
        ticks.percentile(0.50),
        ticks.percentile(0.99),
        ticks.max(),
        waits.longest(),
        robots.get(waits.longestRobot()).name(),
        waits.longestReason(),
        waits.longestUnnamed(),
        contacts.contacts(),
        contacts.wallContacts(),
        contacts.nearest(),
        contacts.nearestWall(),
        robots.stream().mapToDouble(DrivenRobot::metres).sum(),
        robots.getFirst().diameter(),
        seconds,
        seconds / (realNanos / 1e9),
        processorMillis / 1e3,
        runtime.agentNanos() / 1e9,
        Arrays.stream(plans).sum() / 1e3,
        robotNanos / 1e9);
  }

  @Override
  public void close() {
    runtime.await(
        () -> {
          floor.close();
          return true;
        });
    robots.forEach(DrivenRobot::close);
  }
}
