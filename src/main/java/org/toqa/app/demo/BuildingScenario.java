package org.toqa.app.demo;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.app.robot.SimulatedHttpRobot;
import org.toqa.app.server.FleetServer;
import org.toqa.app.server.WebappFolder;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskOrder;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.link.http.RobotToken;
import org.toqa.sim.SimulatedFloor;
import org.toqa.telemetry.Telemetry;
import org.toqa.telemetry.mqtt.ReadingPublisher;

/**
 * CSM-MAMRS as ordinary parts of Toqa: a building of three floors, on each of which one robot with
 * two wheels takes wheel commands over HTTP, publishes by MQTT what its ultrasonic sensors measure,
 * and drives smooth curves. On the first floor somebody walks to and fro.
 */
final class BuildingScenario implements AutoCloseable {
  /** The floors, each a shipped map. */
  private static final List<String> FLOORS = List.of("lab", "offices", "store");

  private static final double FOOTPRINT = 0.255;
  private static final double MAX_LOAD = 5;
  private static final int READY_SECONDS = 60;

  /** Between which somebody walks on the first floor, metres, map frame. */
  private static final Vec2 WALK_START = new Vec2(7.05, 6.45);

  private static final Vec2 WALK_END = new Vec2(7.05, 5.25);

  /** Metres a second (CSM-MAMRS, experiments). */
  private static final double WALK_SPEED = 0.096;

  private static final double WALKER_RADIUS = 0.15;
  private static final long WALK_PERIOD_MILLIS = 100;

  private final List<AutoCloseable> parts = new ArrayList<>();
  private final CountDownLatch closing = new CountDownLatch(1);

  private BuildingScenario() {}

  /**
   * The maps of the floors, whose robots drive smooth curves, as the configuration names them.
   *
   * @param folder gets them
   */
  static String maps(Path folder) throws IOException {
    List<String> files = new ArrayList<>();
    Files.createDirectories(folder);
    Path shipped = WebappFolder.shippedMap().resolveSibling("");
    for (String floor : FLOORS) {
      for (String file : List.of(floor + ".yaml", floor + ".pgm")) {
        Files.copy(shipped.resolve(file), folder.resolve(file));
      }
      String places = Files.readString(shipped.resolve(floor + ".floor.yaml"));
      Files.writeString(folder.resolve(floor + ".floor.yaml"), places + "moves: smooth\n");
      files.add(folder.resolve(floor + ".yaml").toString());
    }
    return String.join(File.pathSeparator, files);
  }

  /** Two tasks on the first floor and one on each other one. */
  static List<TaskOrder> orders() {
    return List.of(
        DemoTasks.order("Parcel to goods-out", 1.5, "Packing 2", "Goods-out", "lab"),
        DemoTasks.order("Post to the archive", 1, "Post room", "Archive", "offices"),
        DemoTasks.order("Pallet to the lift", 4, "Rack 5", "Lift", "store"),
        DemoTasks.order("Parts to assembly", 2.5, "Store C", "Assembly", "lab"));
  }

  /**
   * Puts a robot on each floor, and waits until all are ready.
   *
   * @param user who adds them
   * @throws Exception one cannot be added; the message says why
   */
  static BuildingScenario begin(FleetServer toqa, String user) throws Exception {
    BuildingScenario scenario = new BuildingScenario();
    try {
      List<String> names = new ArrayList<>();
      for (FloorMap floor : toqa.fleet().floors()) {
        names.add("r" + (names.size() + 1));
        scenario.addRobot(toqa, floor, names.getLast(), user);
      }
      return scenario;
    } catch (Exception e) {
      scenario.close();
      throw e;
    }
  }

  private void addRobot(FleetServer toqa, FloorMap floor, String name, String user)
      throws Exception {
    Fleet fleet = toqa.fleet();
    SimulatedFloor world = SimulatedFloor.of(floor);
    Place parking = floor.parking().getFirst();
    Pose start = new Pose(parking.position().x(), parking.position().y(), Math.PI / 2);
    Surroundings surroundings = world.surroundings(name, FOOTPRINT / 2);
    RobotToken token = RobotToken.random();
    SimulatedHttpRobot robot =
        new SimulatedHttpRobot(SimulatedHttpRobot.Settings.of(token, start), surroundings);
    parts.add(robot);
    accepted(
        fleet.addRobot(
            new RobotOrder(
                name,
                "127.0.0.1",
                robot.port(),
                MAX_LOAD,
                parking.name(),
                null,
                null,
                floor.name(),
                new RobotOrder.HttpAccess(token, null)),
            user));
    await(fleet, name, view -> view.state() != RobotState.CONNECTING);
    accepted(fleet.locateRobot(name, start, user));
    await(fleet, name, view -> view.state().isFit());
    Telemetry telemetry = Objects.requireNonNull(toqa.telemetry());
    parts.add(
        UltrasonicSensors.start(
            ReadingPublisher.connect(telemetry.broker(), telemetry.makePassword(name, user)),
            robot::truePose,
            FOOTPRINT / 2,
            surroundings));
    if (floor.name().equals(FLOORS.getFirst())) {
      Thread.ofVirtual().name("walker").start(() -> walk(world));
    }
  }

  /** To and fro, until the demo ends. */
  private void walk(SimulatedFloor world) {
    double there = WALK_START.distanceTo(WALK_END);
    double metres = 0;
    try {
      while (!closing.await(WALK_PERIOD_MILLIS, TimeUnit.MILLISECONDS)) {
        metres = (metres + WALK_SPEED * WALK_PERIOD_MILLIS / 1000) % (2 * there);
        double share = Math.min(metres, 2 * there - metres) / there;
        Vec2 at = WALK_START.plus(WALK_END.minus(WALK_START).times(share));
        world.putObstacle("walker", at, WALKER_RADIUS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static void accepted(CompletionStage<Answer<RobotView>> asked) throws Exception {
    Answer<RobotView> answer = asked.toCompletableFuture().get(READY_SECONDS, TimeUnit.SECONDS);
    if (!(answer instanceof Answer.Accepted<RobotView>)) {
      throw new IllegalStateException(answer.toString());
    }
  }

  private static void await(Fleet fleet, String name, Predicate<RobotView> condition)
      throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(READY_SECONDS);
    FleetSnapshot snapshot = fleet.snapshots().latest();
    while (snapshot.robots().stream()
        .noneMatch(robot -> robot.name().equals(name) && condition.test(robot))) {
      if (System.nanoTime() > end) {
        throw new IllegalStateException(
            String.format(Locale.ROOT, "%s is not ready: %s", name, snapshot.robots()));
      }
      snapshot = fleet.snapshots().awaitNewer(snapshot.version(), Duration.ofMillis(250));
    }
  }

  @Override
  public void close() {
    closing.countDown();
    for (AutoCloseable part : parts.reversed()) {
      try {
        part.close();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      } catch (Exception e) {
        throw new IllegalStateException(e);
      }
    }
  }
}
