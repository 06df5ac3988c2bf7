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
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.toqa.allocation.Policy;
import org.toqa.app.server.TrueBodies;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Pose;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.mission.TaskState;
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

/** A fleet with a real daemon over a simulated body at each parking point of a floor. */
final class LiveFloor {
  private static final double MAX_LOAD = 5;
  private static final Duration LIMIT = Duration.ofSeconds(150);

  private final List<AutoCloseable> parts = new ArrayList<>();
  final VirtualClock clock;
  final SimulatedFloor world;
  final SimulatedFleet robots;
  final AgentFleet fleet;

  /** Of all bodies, at each step of the world. */
  private final ClearanceJudge truth;

  private volatile boolean hasSeenCarriedLoad;

  /**
   * @param world where the robots really are
   * @param speed how many times faster than real time
   */
  LiveFloor(Path folder, FloorMap floor, SimulatedFloor world, double speed) throws Exception {
    this.world = world;
    clock = new VirtualClock(Instant.EPOCH, speed);
    Database database = Database.inMemory("live-" + System.nanoTime());
    parts.add(database);
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    List<SimulatedRobot> bodies =
        floor.parking().stream().map(parking -> body(floor, parking)).toList();
    robots = SimulatedFleet.open(folder, bodies, world, clock);
    parts.add(robots);
    for (Place parking : floor.parking()) {
      String name = body(floor, parking).name();
      store.saveRobot(
          new RobotRecord(
              name,
              floor.name(),
              "127.0.0.1",
              robots.port(name),
              MAX_LOAD,
              parking.name(),
              true,
              null));
    }
    fleet =
        new AgentFleet(
            List.of(floor),
            store,
            new JdbiScheduleStore(database.jdbi()),
            new TcpRobotLinkFactory(new LinkTls(IdentityFile.open(folder)), false),
            Policy.OPTIMAL.allocator(),
            new FleetRules(Duration.ofSeconds(30), ChargingRules.USUAL, speed),
            InstantSource.system(),
            clock.instant());
    parts.add(fleet);
    truth = new ClearanceJudge(floor.grid());
    TrueBodies trueBodies = new TrueBodies(robots, fleet.snapshots()::latest);
    clock.add(nanos -> judge(nanos, trueBodies.all()), VirtualClock.STEP);
    clock.add(nanos -> fleet.tick(clock.instant()), Duration.ofMillis(100));
  }

  private void judge(long nanos, List<Body> bodies) {
    truth.judge(Duration.ofNanos(nanos), bodies);
    hasSeenCarriedLoad |= bodies.stream().anyMatch(body -> !body.carriers().isEmpty());
  }

  private static SimulatedRobot body(FloorMap floor, Place parking) {
    Pose start = new Pose(parking.position().x(), parking.position().y(), 0);
    return new SimulatedRobot("r" + (floor.parking().indexOf(parking) + 1), start, MAX_LOAD, 1);
  }

  /** Lets the time run, and waits until all robots are ready. */
  void start() throws InterruptedException {
    clock.start();
    parts.add(clock);
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
    Answer<TaskView> answer =
        fleet.submit(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);
    return ((Answer.Accepted<TaskView>) answer).value().id();
  }

  FleetSnapshot await(Predicate<FleetSnapshot> condition) throws InterruptedException {
    long end = System.nanoTime() + LIMIT.toNanos();
    FleetSnapshot view = fleet.snapshots().latest();
    while (view.robots().isEmpty() || !condition.test(view)) {
      if (System.nanoTime() > end) {
        fail("It is still so: " + view.tasks() + view.robots() + view.floors());
      }
      view = fleet.snapshots().awaitNewer(view.version(), Duration.ofMillis(100));
    }
    return view;
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
