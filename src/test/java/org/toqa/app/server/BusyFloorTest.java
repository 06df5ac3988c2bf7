package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.allocation.Policy;
import org.toqa.fleet.Answer;
import org.toqa.fleet.ChargingRules;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FloorsInMemory;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.ServerRuntime;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;
import org.toqa.mission.TaskState;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Two real daemons that have to pass each other, and a plan for both of them that never ends; a
 * third one drives apart from them, and a fourth one on another floor.
 */
@Tag("full")
class BusyFloorTest {
  /**
   * A machine that is busy must not make a robot count as lost: with a plan that never ends it
   * would get no other path.
   */
  private static final double SPEED = 1;

  private static final long LIMIT_NANOS = Duration.ofMinutes(5).toNanos();

  @TempDir private Path folder;
  private final List<AutoCloseable> parts = new ArrayList<>();
  private final EndlessPlanning runtime = new EndlessPlanning();
  private final Map<String, Integer> pings = new ConcurrentHashMap<>();
  private final Map<String, Mode> modes = new ConcurrentHashMap<>();
  private AgentFleet fleet;

  @BeforeEach
  void open() throws Exception {
    List<Place> places =
        List.of(
            new Place("Left", new Vec2(0.5, 3.5)),
            new Place("Right", new Vec2(11.5, 3.5)),
            new Place("Begin", new Vec2(0.5, 0.5)),
            new Place("End", new Vec2(6.5, 0.5)));
    FloorMap floor =
        new FloorMap(
            "aisle",
            OccupancyGrid.parse("............", "###..#######", "############", "............"),
            places,
            List.of(),
            List.of());
    FloorMap hall =
        new FloorMap(
            "hall",
            OccupancyGrid.parse("......", "......"),
            List.of(new Place("A", new Vec2(0.5, 0.5)), new Place("B", new Vec2(5.5, 1.5))),
            List.of(),
            List.of());
    VirtualClock clock = new VirtualClock(Instant.EPOCH, SPEED);
    SimulatedFleet robots =
        SimulatedFleet.open(
            folder,
            Map.of(
                SimulatedFloor.of(floor),
                List.of(
                    new SimulatedRobot("r1", new Pose(0.5, 3.5, 0), 5, 1),
                    new SimulatedRobot("r2", new Pose(11.5, 3.5, 0), 5, 1),
                    new SimulatedRobot("r3", new Pose(0.5, 0.5, 0), 5, 1)),
                SimulatedFloor.of(hall),
                List.of(new SimulatedRobot("r4", new Pose(2.5, 1.5, 0), 5, 1))),
            clock);
    parts.add(robots);
    Database database = MemoryDatabase.open("busy-" + System.nanoTime());
    parts.add(database);
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    for (String robot : List.of("r1", "r2", "r3", "r4")) {
      String where = robot.equals("r4") ? hall.name() : floor.name();
      store.saveRobot(
          RobotRecord.direct(robot, where, "127.0.0.1", robots.port(robot), 5, null, true, null));
    }
    SimulatedLinks links =
        new SimulatedLinks(
            new TcpRobotLinkFactory(new LinkTls(IdentityFile.open(folder)), false),
            robots::isListeningOn,
            clock::nanos);
    clock.add(links, VirtualClock.STEP);
    fleet =
        new AgentFleet(
            FloorsInMemory.of(floor, hall),
            store,
            new JdbiScheduleStore(database.jdbi()),
            new WatchedLinks(links),
            Policy.OPTIMAL.method(),
            new FleetRules(Duration.ofSeconds(30), ChargingRules.USUAL, SPEED),
            InstantSource.system(),
            clock.instant(),
            runtime);
    parts.add(fleet);
    clock.add(new FleetInWorld(fleet, clock, true), Duration.ofMillis(100));
    clock.start();
    parts.add(clock);
  }

  @AfterEach
  void close() throws Exception {
    runtime.end.countDown();
    for (AutoCloseable part : parts.reversed()) {
      part.close();
    }
  }

  @Test
  void robotsArePingedReleasedShownAndStoppedAllTheSame() throws Exception {
    until(
        () ->
            fleet.snapshots().latest().robots().stream()
                    .filter(r -> r.state() == RobotState.IDLE)
                    .count()
                == 4);
    order("Begin", "End");
    until(() -> eastOf("r3") > 1.5);
    long crossing = order("Left", "Right");
    order("Right", "Left");
    assertTrue(runtime.isPlanning.await(60, TimeUnit.SECONDS));
    assertTrue(eastOf("r3") < 6, "it has nearly arrived");
    until(() -> eastOf("r3") > 6.4);

    long elsewhere = order("A", "B");
    until(() -> isDone(elsewhere));
    assertFalse(isDone(crossing), "there is no plan for it");

    pings.clear();
    until(() -> pings.getOrDefault("r1", 0) >= 10 && pings.getOrDefault("r2", 0) >= 10);
    assertFalse(modes.get("r1") == Mode.HOLDING);
    var held = fleet.holdRobot("r1", "Clara");
    until(() -> modes.get("r1") == Mode.HOLDING);
    assertFalse(modes.get("r2") == Mode.HOLDING);
    var paused = fleet.pauseAll("Clara");
    until(() -> modes.get("r2") == Mode.HOLDING);

    String overdue = Phrase.PLAN_OVERDUE.with("aisle").toString();
    until(() -> fleet.snapshots().latest().alerts().toString().contains(overdue));
    runtime.end.countDown();
    held.toCompletableFuture().get(60, TimeUnit.SECONDS);
    paused.toCompletableFuture().get(60, TimeUnit.SECONDS);
  }

  private boolean isDone(long task) {
    return fleet.snapshots().latest().tasks().stream()
        .anyMatch(view -> view.id() == task && view.state() == TaskState.DONE);
  }

  /** Where the snapshots show it, metres. */
  private double eastOf(String robot) {
    return fleet.snapshots().latest().robots().stream()
        .filter(view -> view.name().equals(robot))
        .map(view -> view.telemetry().pose())
        .filter(Objects::nonNull)
        .mapToDouble(Pose::x)
        .findFirst()
        .orElse(0);
  }

  private long order(String from, String to) throws Exception {
    TaskOrder order =
        new TaskOrder(
            "crate",
            2,
            new TaskOrder.Where.Station(from),
            new TaskOrder.Where.Station(to),
            null,
            0,
            null,
            null);
    Answer<TaskView> answer =
        fleet.submit(order, "Clara").toCompletableFuture().get(30, TimeUnit.SECONDS);
    assertInstanceOf(Answer.Accepted.class, answer);
    return ((Answer.Accepted<TaskView>) answer).value().id();
  }

  private void until(BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + LIMIT_NANOS;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, () -> fleet.snapshots().latest().robots().toString());
      TimeUnit.MILLISECONDS.sleep(5);
    }
  }

  /** As a server's, but that the first plan for several robots lasts until it is ended. */
  private static final class EndlessPlanning extends ServerRuntime {
    final CountDownLatch isPlanning = new CountDownLatch(1);
    final CountDownLatch end = new CountDownLatch(1);

    @Override
    public void recordPlanning(long nanos) {
      isPlanning.countDown();
      try {
        end.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** Links that count pings, and know what the robots do. */
  private final class WatchedLinks implements RobotLinkFactory {
    private final RobotLinkFactory links;

    WatchedLinks(RobotLinkFactory links) {
      this.links = links;
    }

    @Override
    public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
      RobotLink link = links.open(address, new Watched(address.robot(), listener));
      return new RobotLink() {
        @Override
        public void send(ServerMessage message) {
          if (message instanceof ServerMessage.Ping) {
            pings.merge(address.robot(), 1, Integer::sum);
          }
          link.send(message);
        }

        @Override
        public void close() {
          link.close();
        }
      };
    }

    @Override
    public PairingResult pair(RobotAddress robot, PairingCode code) {
      return links.pair(robot, code);
    }
  }

  private final class Watched implements RobotLink.Listener {
    private final String robot;
    private final RobotLink.Listener listener;

    Watched(String robot, RobotLink.Listener listener) {
      this.robot = robot;
      this.listener = listener;
    }

    @Override
    public void connected(Hello hello) {
      listener.connected(hello);
    }

    @Override
    public boolean received(AgentMessage message) {
      if (message instanceof State state) {
        modes.put(robot, state.mode());
      }
      return listener.received(message);
    }

    @Override
    public void passedOver(int states, int unreadable) {
      listener.passedOver(states, unreadable);
    }

    @Override
    public void disconnected(Sentence why) {
      listener.disconnected(why);
    }

    @Override
    public void refused(Sentence sentence) {
      listener.refused(sentence);
    }
  }
}
