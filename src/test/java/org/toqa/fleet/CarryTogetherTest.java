package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
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
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.allocation.Policy;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.TcpRobotLinks;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.mission.TaskState;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;

/** Real daemons over simulated bodies carry heavy loads, from the order to the way home. */
class CarryTogetherTest {
  private static final double SPEED = 6;
  private static final long LIMIT_NANOS = Duration.ofSeconds(150).toNanos();
  private static final double MAX_LOAD = 5;
  private static final double SIZE = 0.3;

  /** Cells of 0.3 m: a hall of 12 m x 4.2 m. */
  private static final String[] HALL = hall(40, 14);

  @TempDir private Path folder;
  private final List<AutoCloseable> parts = new ArrayList<>();
  private final VirtualClock clock = new VirtualClock(Instant.EPOCH, SPEED);
  private @Nullable AgentFleet opened;

  @AfterEach
  void close() throws Exception {
    for (AutoCloseable part : parts.reversed()) {
      part.close();
    }
  }

  @Test
  @Timeout(300)
  void twoRobotsCarryWhatIsTooHeavyForOne() throws Exception {
    open(2);
    long task = order(8);
    FleetSnapshot carrying = until(view -> is(view, task, TaskState.CARRYING));
    assertEquals(2, task(carrying, task).robots().size());
    untilDone(task);
  }

  @Test
  @Timeout(300)
  void threeRobotsCarryWhatIsTooHeavyForTwo() throws Exception {
    open(3);
    long task = order(12);
    FleetSnapshot carrying = until(view -> is(view, task, TaskState.CARRYING));
    assertEquals(3, task(carrying, task).robots().size());
    untilDone(task);
  }

  /** No two discs meet meanwhile, and no follower is off its place by more than the tolerance. */
  private void untilDone(long task) throws Exception {
    until(
        view -> {
          assertApart(view);
          assertEquals(List.of(), outOfPlace(view));
          return is(view, task, TaskState.DONE);
        });
  }

  private static List<String> outOfPlace(FleetSnapshot view) {
    return view.robots().stream()
        .flatMap(r -> r.errors().stream())
        .filter(fault -> fault.code().equals("OUT_OF_PLACE"))
        .map(Fault::text)
        .toList();
  }

  private static void assertApart(FleetSnapshot view) {
    List<RobotView> robots = view.robots();
    for (int i = 0; i < robots.size(); i++) {
      for (int j = 0; j < i; j++) {
        Pose a = Objects.requireNonNull(robots.get(i).pose());
        Pose b = Objects.requireNonNull(robots.get(j).pose());
        double gap = a.distanceTo(b) - (robots.get(i).footprint() + robots.get(j).footprint()) / 2;
        assertTrue(gap > 0, robots.get(i) + " meets " + robots.get(j));
      }
    }
  }

  private static boolean is(FleetSnapshot view, long task, TaskState state) {
    return view.tasks().stream().anyMatch(t -> t.id() == task && t.state() == state);
  }

  private static TaskView task(FleetSnapshot view, long id) {
    return view.tasks().stream().filter(t -> t.id() == id).findFirst().orElseThrow();
  }

  private long order(double load) throws Exception {
    TaskOrder order =
        new TaskOrder(
            "gearbox",
            load,
            new TaskOrder.Where.Station("A"),
            new TaskOrder.Where.Station("B"),
            null,
            0,
            null,
            null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    Answer<TaskView> answer =
        fleet().submit(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);
    return ((Answer.Accepted<TaskView>) answer).value().id();
  }

  private AgentFleet fleet() {
    return Objects.requireNonNull(opened);
  }

  private void open(int count) throws Exception {
    List<Place> parking = new ArrayList<>();
    List<SimulatedRobot> robots = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Vec2 at = cell(4 + 4 * i, 2);
      parking.add(new Place("P" + (i + 1), at));
      robots.add(new SimulatedRobot("r" + (i + 1), new Pose(at.x(), at.y(), 0), MAX_LOAD, 1));
    }
    List<Place> stations = List.of(new Place("A", cell(8, 8)), new Place("B", cell(30, 8)));
    FloorMap floor = new FloorMap("hall", grid(), stations, parking, List.of());
    Database database = Database.inMemory("together-" + System.nanoTime());
    parts.add(database);
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    SimulatedFleet simulated = SimulatedFleet.open(folder, robots, List.of(), clock);
    parts.add(simulated);
    for (int i = 0; i < count; i++) {
      String name = robots.get(i).name();
      store.saveRobot(
          new RobotRecord(
              name,
              "hall",
              "127.0.0.1",
              simulated.port(name),
              MAX_LOAD,
              parking.get(i).name(),
              true,
              null));
    }
    AgentFleet fleet =
        new AgentFleet(
            List.of(floor),
            store,
            new TcpRobotLinks(new LinkTls(IdentityFile.open(folder)), false),
            Policy.OPTIMAL.allocator(),
            new FleetRules(Duration.ofSeconds(30), ChargingRules.USUAL, SPEED),
            InstantSource.system(),
            clock.instant());
    opened = fleet;
    parts.add(fleet);
    clock.add(nanos -> fleet.tick(clock.instant()), Duration.ofMillis(100));
    clock.start();
    parts.add(clock);
  }

  private FleetSnapshot until(Predicate<FleetSnapshot> condition) throws InterruptedException {
    long end = System.nanoTime() + LIMIT_NANOS;
    FleetSnapshot view = fleet().feed().latest();
    while (view.robots().isEmpty() || !condition.test(view)) {
      if (System.nanoTime() > end) {
        fail("It is still so: " + view.tasks() + view.robots());
      }
      view = fleet().feed().awaitNewer(view.version(), Duration.ofMillis(100));
    }
    return view;
  }

  private static OccupancyGrid grid() {
    OccupancyGrid drawn = OccupancyGrid.parse(HALL);
    return new OccupancyGrid(drawn.width(), drawn.height(), SIZE, Vec2.ZERO, drawn.occupied());
  }

  private static Vec2 cell(int column, int rowFromBelow) {
    return new Vec2((column + 0.5) * SIZE, (rowFromBelow + 0.5) * SIZE);
  }

  private static String[] hall(int columns, int rows) {
    String[] hall = new String[rows];
    for (int row = 0; row < rows; row++) {
      boolean isWall = row == 0 || row == rows - 1;
      hall[row] = isWall ? "#".repeat(columns) : "#" + ".".repeat(columns - 2) + "#";
    }
    return hall;
  }
}
