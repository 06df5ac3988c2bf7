package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.allocation.Policy;
import org.toqa.app.robot.SimulatedHttpRobot;
import org.toqa.app.robot.SimulatedHttpRobot.Fault;
import org.toqa.fleet.Answer;
import org.toqa.fleet.ChargingRules;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorsInMemory;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.http.RobotDescription.Sonar;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.localisation.GridWalls;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.MemoryDatabase;

/** Where a fleet takes a robot to be that takes wheel commands and has forgotten where it is. */
@Tag("full")
@Timeout(120)
class HttpRobotPlaceTest {
  private static final RobotToken TOKEN = new RobotToken("a-token-of-a-test");
  private static final Pose START = new Pose(3, 4, 0);
  private static final Duration LIMIT = Duration.ofSeconds(60);

  /** A room of 6 m x 8 m, outside of which everything is wall. */
  private static final OccupancyGrid ROOM = new OccupancyGrid(60, 80, 0.1, Vec2.ZERO, new BitSet());

  @TempDir private Path folder;
  private final List<AutoCloseable> parts = new ArrayList<>();
  private final ScheduledExecutorService timers = Executors.newScheduledThreadPool(2);
  private final PublishedRanges ranges = new PublishedRanges(System::nanoTime);
  private SimulatedHttpRobot robot;
  private AgentFleet fleet;

  @BeforeEach
  void open() throws Exception {
    robot = robotAt(0);
    Database database = MemoryDatabase.open("http-place-" + System.nanoTime());
    parts.add(database);
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    store.saveRobot(
        new RobotRecord(
            "h1", "room", "127.0.0.1", robot.port(), 5, null, false, null, null, TOKEN));
    LinkTls tls = new LinkTls(IdentityFile.open(folder));
    TcpRobotLinkFactory tcp = new TcpRobotLinkFactory(tls, false);
    fleet =
        new AgentFleet(
            FloorsInMemory.of(new FloorMap("room", ROOM, List.of(), List.of(), List.of())),
            store,
            new JdbiScheduleStore(database.jdbi()),
            new HttpRobotLinks(
                tcp,
                tcp,
                folder.resolve("robots"),
                tls.fingerprint(),
                false,
                ranges,
                InstantSource.system()),
            Policy.OPTIMAL.method(),
            new FleetRules(Duration.ofSeconds(30), ChargingRules.USUAL, 1),
            InstantSource.system(),
            Instant.now());
    parts.add(fleet);
    var _ =
        timers.scheduleAtFixedRate(() -> fleet.tick(Instant.now()), 0, 100, TimeUnit.MILLISECONDS);
    until(view -> view.state() == RobotState.NOT_LOCALISED);
    assertNull(view().telemetry().pose());
    assertInstanceOf(
        Answer.Accepted.class,
        fleet.locateRobot("h1", START, "Max").toCompletableFuture().get(10, TimeUnit.SECONDS));
    until(view -> view.state() == RobotState.IDLE);
  }

  @AfterEach
  void close() throws Exception {
    timers.shutdownNow();
    for (AutoCloseable part : parts.reversed()) {
      part.close();
    }
    robot.close();
    HttpRobotLinkTest.awaitNoDaemon();
  }

  private static SimulatedHttpRobot robotAt(int port) throws IOException {
    SimulatedHttpRobot.Settings usual = SimulatedHttpRobot.Settings.of(TOKEN, START);
    return new SimulatedHttpRobot(
        new SimulatedHttpRobot.Settings(
            usual.address(),
            port,
            TOKEN,
            null,
            null,
            START,
            0,
            0,
            1,
            5,
            Duration.ZERO,
            List.of(),
            new Sonar(5, 0.01)));
  }

  @Test
  void whoWasSwitchedOffIsWhereItWas() throws Exception {
    int port = robot.port();
    robot.close();
    until(view -> view.state() == RobotState.LOST);

    robot = robotAt(port);

    until(view -> view.state() == RobotState.NOT_LOCALISED);
    assertAt(START);
  }

  @Test
  void whoseCountsHaveJumpedIsWhereItWas() throws Exception {
    robot.setFault(Fault.JUMPED_COUNTS);

    until(view -> view.state() == RobotState.NOT_LOCALISED);
    assertAt(START);
  }

  /** It sees nothing where walls should be. */
  @Test
  void whoHasLostItselfIsWhereItTookItselfToBe() throws Exception {
    var _ = timers.scheduleAtFixedRate(this::publish, 0, 50, TimeUnit.MILLISECONDS);
    Where start = new Where.Point(new Vec2(4.95, 4.05));
    Where goal = new Where.Point(new Vec2(1.05, 4.05));
    TaskOrder order = new TaskOrder("box", 1, start, goal, null, 0, null, null);
    assertInstanceOf(
        Answer.Accepted.class,
        fleet.submit(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS));

    until(view -> view.state() == RobotState.NOT_LOCALISED);

    assertAt(robot.truePose());
  }

  private void publish() {
    ranges.put(
        "h1",
        List.of(20.0, 20.0, 20.0, 20.0),
        List.of(0.0, Math.PI / 2, Math.PI, -Math.PI / 2),
        () -> Optional.of(new GridWalls(ROOM)));
  }

  private void assertAt(Pose place) {
    Pose pose = view().telemetry().pose();
    assertNotNull(pose);
    assertEquals(0, pose.distanceTo(place), 0.2, pose::toString);
  }

  private RobotView view() {
    return fleet.snapshots().latest().robots().getFirst();
  }

  private void until(Predicate<RobotView> condition) throws InterruptedException {
    Instant end = Instant.now().plus(LIMIT);
    FleetSnapshot now = fleet.snapshots().latest();
    while (now.robots().isEmpty() || !condition.test(now.robots().getFirst())) {
      if (Instant.now().isAfter(end)) {
        fail("It is still so: " + now);
      }
      now = fleet.snapshots().awaitNewer(now.version(), LIMIT);
    }
  }
}
