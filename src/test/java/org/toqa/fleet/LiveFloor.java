package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.jdbi.v3.core.Jdbi;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Policy;
import org.toqa.app.server.TrueBodies;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.gateway.Gateways;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.mission.TaskState;
import org.toqa.motion.DriveKind;
import org.toqa.sim.Body;
import org.toqa.sim.ClearanceJudge;
import org.toqa.sim.ClearanceJudge.Clearance;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.MemoryDatabase;

/**
 * A fleet with a real daemon over a simulated body at each parking point of a floor. The test's own
 * thread moves the world, a step at a time, and each step only when what the steps before it
 * brought about has come where it was sent: no machine is too slow, every picture is looked at, and
 * the same test is the same run.
 */
final class LiveFloor {
  private static final double MAX_LOAD = 5;

  /** Of the world's time, for one condition. */
  private static final Duration LIMIT = Duration.ofMinutes(30);

  /** For a world that does not go on at all; nothing else depends on it. */
  private static final Duration HANGS_AFTER = Duration.ofSeconds(60);

  private static final long LOOK_AGAIN_NANOS = 100_000;

  private final List<AutoCloseable> parts = new ArrayList<>();
  private final SingleThreadRuntime runtime = new SingleThreadRuntime();
  private final SteppedLinks links;
  private final Database database;
  private final long stepNanos;
  private long due;
  final VirtualClock clock;
  final SimulatedFloor world;
  final SimulatedFleet robots;
  final AgentFleet fleet;
  final Jdbi jdbi;
  final JdbiFleetStore store;
  final FloorsInMemory floors;

  /** Of all bodies, at each step of the world. */
  private final ClearanceJudge truth;

  private volatile boolean hasSeenCarriedLoad;

  /** Where robots really are, by name. */
  private volatile Map<String, Vec2> truePlaces = Map.of();

  /**
   * @param world where the robots really are
   * @param speed how many times faster than real time at most
   */
  LiveFloor(Path folder, FloorMap floor, SimulatedFloor world, double speed) throws Exception {
    this(folder, floor, world, speed, DriveKind.OMNI);
  }

  /** The same with robots of a kind. */
  LiveFloor(Path folder, FloorMap floor, SimulatedFloor world, double speed, DriveKind kind)
      throws Exception {
    this(folder, floor, world, speed, kind, UnaryOperator.identity(), null, _ -> Gateways.NONE);
  }

  /** The same with what else robots have. */
  LiveFloor(
      Path folder,
      FloorMap floor,
      SimulatedFloor world,
      double speed,
      UnaryOperator<SimulatedRobot> equipment)
      throws Exception {
    this(folder, floor, world, speed, DriveKind.OMNI, equipment, null, _ -> Gateways.NONE);
  }

  /**
   * @param gateway reaches all robots; null: the server does
   * @param gateways those of the server, made when the robots are there
   */
  LiveFloor(
      Path folder,
      FloorMap floor,
      SimulatedFloor world,
      double speed,
      @Nullable String gateway,
      Function<SimulatedFleet, Gateways> gateways)
      throws Exception {
    this(folder, floor, world, speed, DriveKind.OMNI, UnaryOperator.identity(), gateway, gateways);
  }

  /** With robots on two wheels that have four agents. */
  static LiveFloor withFourAgents(Path folder, FloorMap floor, SimulatedFloor world, double speed)
      throws Exception {
    return new LiveFloor(folder, floor, world, speed, SimulatedRobot::withFourAgents);
  }

  private LiveFloor(
      Path folder,
      FloorMap floor,
      SimulatedFloor world,
      double speed,
      DriveKind kind,
      UnaryOperator<SimulatedRobot> equipment,
      @Nullable String gateway,
      Function<SimulatedFleet, Gateways> gateways)
      throws Exception {
    this.world = world;
    clock = new VirtualClock(Instant.EPOCH, speed);
    stepNanos = Math.round(VirtualClock.STEP.toNanos() / speed);
    parts.add(runtime);
    database = MemoryDatabase.open("live-" + System.nanoTime());
    parts.add(database);
    jdbi = database.jdbi();
    store = new JdbiFleetStore(jdbi);
    List<SimulatedRobot> bodies =
        floor.parking().stream()
            .map(parking -> equipment.apply(body(floor, parking, kind)))
            .toList();
    robots = SimulatedFleet.open(folder, bodies, world, clock);
    parts.add(robots);
    for (Place parking : floor.parking()) {
      String name = body(floor, parking, kind).name();
      store.saveRobot(
          new RobotRecord(
              name,
              floor.name(),
              "127.0.0.1",
              robots.port(name),
              MAX_LOAD,
              parking.name(),
              true,
              null,
              gateway,
              null));
    }
    links =
        new SteppedLinks(
            new TcpRobotLinkFactory(
                new LinkTls(IdentityFile.open(folder)),
                gateways.apply(robots),
                gateway != null, // whose robots are not paired here
                1));
    floors = FloorsInMemory.of(floor);
    fleet =
        new AgentFleet(
            floors,
            store,
            new JdbiScheduleStore(database.jdbi()),
            links,
            Policy.OPTIMAL.method(),
            new FleetRules(Duration.ofSeconds(30), ChargingRules.USUAL, speed),
            InstantSource.system(),
            clock.instant(),
            runtime);
    parts.add(fleet);
    truth = new ClearanceJudge(floor.grid());
    TrueBodies trueBodies = new TrueBodies(robots, fleet.snapshots()::latest);
    clock.add(nanos -> judge(nanos, trueBodies.on(floor.name())), VirtualClock.STEP);
    clock.add(nanos -> fleet.tick(clock.instant()), Duration.ofMillis(100));
  }

  private void judge(long nanos, List<Body> bodies) {
    truth.judge(Duration.ofNanos(nanos), bodies);
    truePlaces =
        bodies.stream()
            .filter(body -> body.core().size() == 1)
            .collect(Collectors.toMap(Body::name, body -> body.core().getFirst()));
    hasSeenCarriedLoad |= bodies.stream().anyMatch(body -> !body.carriers().isEmpty());
  }

  private static SimulatedRobot body(FloorMap floor, Place parking, DriveKind kind) {
    Pose start = new Pose(parking.position().x(), parking.position().y(), 0);
    String name = "r" + (floor.parking().indexOf(parking) + 1);
    return new SimulatedRobot(name, start, MAX_LOAD, 1, kind, null);
  }

  /** Waits until all robots are ready. */
  void start() throws InterruptedException {
    await(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
  }

  /** Orders a transport between two stations; the task's number. */
  long submit(double load, String from, String to) throws Exception {
    TaskOrder order =
        new TaskOrder(
            "gearbox",
            load,
            new TaskOrder.Where.Station(from),
            new TaskOrder.Where.Station(to),
            null,
            0,
            null,
            null);
    return submit(order);
  }

  /** The task's number. */
  long submit(TaskOrder order) throws Exception {
    Answer<TaskView> answer =
        fleet.submit(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);
    return ((Answer.Accepted<TaskView>) answer).value().id();
  }

  /** Lets the world go on until it is so. */
  FleetSnapshot await(Predicate<FleetSnapshot> condition) throws InterruptedException {
    long end = clock.nanos() + LIMIT.toNanos();
    runtime.awaitQuiescence();
    FleetSnapshot view = fleet.snapshots().latest();
    while (view.robots().isEmpty() || !condition.test(view)) {
      if (clock.nanos() > end) {
        fail("It is still so: " + view.tasks() + view.robots() + view.floors());
      }
      step();
      view = fleet.snapshots().latest();
    }
    return view;
  }

  /** Lets that much of the world's time go on. */
  void pass(Duration time) throws InterruptedException {
    long end = clock.nanos() + time.toNanos();
    await(_ -> clock.nanos() >= end);
  }

  /** Whether the store has a free zone as a robot's own. */
  boolean isZoneLent() {
    return database
            .jdbi()
            .withHandle(
                h ->
                    h.createQuery("select count(*) from drives where zone_width is not null")
                        .mapTo(Integer.class)
                        .one())
        > 0;
  }

  /** Where a robot's middle really is, map frame. */
  Vec2 truePlace(String robot) {
    return Objects.requireNonNull(truePlaces.get(robot));
  }

  /** The server is no more, and nobody tells the robots so; the world goes on by one step. */
  void stepWithoutServer() {
    while (!clock.isReady()) {
      LockSupport.parkNanos(LOOK_AGAIN_NANOS);
    }
    clock.advance(VirtualClock.STEP);
  }

  private void step() throws InterruptedException {
    long hangs = System.nanoTime() + HANGS_AFTER.toNanos();
    while (!isReady()) {
      if (System.nanoTime() > hangs) {
        fail("The world does not go on: " + links);
      }
      LockSupport.parkNanos(LOOK_AGAIN_NANOS);
    }
    while (System.nanoTime() < due) {
      LockSupport.parkNanos(due - System.nanoTime());
    }
    due = System.nanoTime() + stepNanos;
    clock.advance(VirtualClock.STEP);
    runtime.awaitQuiescence();
  }

  /** Whether the next step may come: whatever was said has come, and nobody waits for more. */
  private boolean isReady() throws InterruptedException {
    if (!links.areSettled(robots)) {
      return false;
    }
    if (links.haveArrived()) {
      runtime.runWhileHeldUp(links::deliver);
      return links.areSettled(robots) && !links.haveArrived() && clock.isReady();
    }
    return clock.isReady();
  }

  static TaskView task(FleetSnapshot view, long id) {
    return view.tasks().stream().filter(t -> t.id() == id).findFirst().orElseThrow();
  }

  static boolean isInState(FleetSnapshot view, long task, TaskState state) {
    return view.tasks().stream().anyMatch(t -> t.id() == task && t.state() == state);
  }

  /** Whether a load that several robots carry was among the bodies that were judged. */
  boolean hasSeenCarriedLoad() {
    return hasSeenCarriedLoad;
  }

  /** No body has touched another one or a wall, where they really were. */
  private void assertClear() {
    assertTrue(truth.samples() > 0);
    truth.betweenBodies().ifPresent(nearest -> assertFalse(nearest.isTouch(), nearest::toString));
    Clearance wall = truth.toWall().orElseThrow();
    assertFalse(wall.isTouch(), wall::toString);
  }

  /** Whatever a test is about: what was to be clear of each other must have been. */
  void close() throws Exception {
    for (AutoCloseable part : parts.reversed()) {
      part.close();
    }
    assertClear();
  }
}
