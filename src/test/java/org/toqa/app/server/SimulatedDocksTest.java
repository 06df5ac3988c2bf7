package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.allocation.Policy;
import org.toqa.fleet.Answer;
import org.toqa.fleet.ChargingRules;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorsInMemory;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.history.EventArchive.Filter;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Pose;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;
import org.toqa.store.Database;
import org.toqa.store.JdbiEventArchive;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.MemoryDatabase;

/** One robot parked in its dock, and one that stands where no dock is. */
@Timeout(120)
class SimulatedDocksTest {
  private static final Pose DOCKED = new Pose(1.5, 1.5, 0);
  private static final Pose ELSEWHERE = new Pose(5.5, 1.5, 0);
  private static final Pose ASIDE = new Pose(0.3, 0.2, 0.4);
  private static final double SPEED = 20;

  @TempDir private Path folder;
  private final List<AutoCloseable> parts = new ArrayList<>();
  private AgentFleet fleet;
  private SimulatedFleet robots;
  private JdbiEventArchive archive;

  @BeforeEach
  void open() throws Exception {
    FloorMap floor =
        new FloorMap(
            "hall",
            OccupancyGrid.parse("........", "........", "........"),
            List.of(),
            List.of(new Place("P1", DOCKED.position())),
            List.of());
    VirtualClock clock = new VirtualClock(Instant.EPOCH, SPEED);
    robots =
        SimulatedFleet.open(
            folder,
            List.of(
                new SimulatedRobot("r1", DOCKED, 5, 1), new SimulatedRobot("r2", ELSEWHERE, 5, 1)),
            SimulatedFloor.boundless(),
            clock);
    parts.add(robots);
    Database database = MemoryDatabase.open("docks-" + System.nanoTime());
    parts.add(database);
    archive = new JdbiEventArchive(database.jdbi());
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    for (String robot : List.of("r1", "r2")) {
      String parking = robot.equals("r1") ? "P1" : null;
      store.saveRobot(
          RobotRecord.direct(
              robot, "hall", "127.0.0.1", robots.port(robot), 5, parking, true, null));
    }
    fleet =
        new AgentFleet(
            FloorsInMemory.of(floor),
            store,
            new JdbiScheduleStore(database.jdbi()),
            new TcpRobotLinkFactory(new LinkTls(IdentityFile.open(folder)), false),
            Policy.OPTIMAL.method(),
            new FleetRules(Duration.ofSeconds(30), ChargingRules.USUAL, SPEED),
            InstantSource.system(),
            clock.instant());
    parts.add(fleet);
    SimulatedDocks docks = new SimulatedDocks(robots, fleet);
    clock.add(nanos -> fleet.tick(clock.instant()), Duration.ofMillis(100));
    clock.add(nanos -> docks.locateStandingRobots(), SimulatedDocks.PERIOD);
    clock.start();
    parts.add(clock);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
  }

  @AfterEach
  void close() throws Exception {
    for (AutoCloseable part : parts.reversed()) {
      part.close();
    }
  }

  @Test
  void aRobotThatIsWrongAboutItsPlaceIsToldByItsDockAndOnlyThere() throws Exception {
    Pose wrong = ELSEWHERE.compose(ASIDE);
    isTold("r2", wrong);
    until(view -> pose(view, "r2").distanceTo(wrong) < 0.01);

    isTold("r1", DOCKED.compose(ASIDE));
    until(
        view ->
            hasSpoken("The dock P1", "r1")
                && pose(view, "r1").distanceTo(robots.truePose("r1").orElseThrow()) < 0.01);
    assertFalse(hasSpoken("The dock P1", "r2"));

    assertEquals(0, pose(fleet.snapshots().latest(), "r2").distanceTo(wrong), 0.01);
  }

  private boolean hasSpoken(String dock, String ofRobot) {
    Filter filter = new Filter(null, ofRobot, dock, null, null, null, true);
    return !archive.events(filter, Long.MAX_VALUE, 1).isEmpty();
  }

  /** Asked until it is heard: at this speed a robot counts as lost after a tenth of a second. */
  private void isTold(String robot, Pose pose) throws Exception {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    Answer<?> answer = locate(robot, pose);
    while (!(answer instanceof Answer.Accepted)) {
      assertTrue(System.nanoTime() < end, answer::toString);
      until(view -> isIdle(view, robot));
      answer = locate(robot, pose);
    }
  }

  private Answer<?> locate(String robot, Pose pose) throws Exception {
    return fleet.locateRobot(robot, pose, "Max").toCompletableFuture().get(10, TimeUnit.SECONDS);
  }

  private static boolean isIdle(FleetSnapshot view, String robot) {
    return view.robots().stream()
        .anyMatch(r -> r.name().equals(robot) && r.state() == RobotState.IDLE);
  }

  private static Pose pose(FleetSnapshot view, String robot) {
    return view.robots().stream()
        .filter(r -> r.name().equals(robot))
        .map(r -> r.telemetry().pose())
        .map(Objects::requireNonNull)
        .findFirst()
        .orElseThrow();
  }

  private void until(Predicate<FleetSnapshot> condition) throws InterruptedException {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    FleetSnapshot view = fleet.snapshots().latest();
    while (view.robots().isEmpty() || !condition.test(view)) {
      if (System.nanoTime() > end) {
        fail("It is still so: " + view.robots());
      }
      view = fleet.snapshots().awaitNewer(view.version(), Duration.ofMillis(100));
    }
  }
}
