package org.toqa.app.demo;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
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
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.app.robot.SimulatedHttpRobot;
import org.toqa.app.server.FleetServer;
import org.toqa.app.server.WebappFolder;
import org.toqa.camera.CameraOrder;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.LoadView;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskOrder;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.link.http.RobotToken;
import org.toqa.sim.SimulatedCamera;
import org.toqa.sim.SimulatedCamera.Standing;
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

  /** Standard deviations, as shares: of what a wheel turns, and of its size. */
  private static final double SLIP = 0.01;

  private static final double SIZE_ERROR = 0.001;

  /** Radians, from right to left: where the range sensors look by which it avoids things. */
  private static final List<Double> RANGE_ANGLES =
      Stream.of(-90, -50, -25, -10, 0, 10, 25, 50, 90).map(Math::toRadians).toList();

  private static final int READY_SECONDS = 60;

  /** Between which somebody walks on the first floor, metres, map frame. */
  private static final Vec2 WALK_START = new Vec2(7.05, 6.45);

  private static final Vec2 WALK_END = new Vec2(7.05, 5.25);

  /** Metres a second (CSM-MAMRS, experiments). */
  private static final double WALK_SPEED = 0.096;

  private static final double WALKER_RADIUS = 0.15;
  private static final long WALK_PERIOD_MILLIS = 100;

  /** Where the camera of the first floor is, which looks at whoever walks there. */
  private static final Vec2 WATCH = new Vec2(5.05, 6.45);

  /** As cameras show them: metres, and red, green and blue. */
  private static final double ROBOT_HEIGHT = 0.2;

  private static final double WALKER_HEIGHT = 0.7;
  private static final double LOAD_HEIGHT = 0.15;
  private static final double LOAD_RADIUS = 0.1;
  private static final int ROBOT_COLOUR = 0x2F6FDE;
  private static final int WALKER_COLOUR = 0xD9534F;
  private static final int LOAD_COLOUR = 0xC98A2B;

  private final List<AutoCloseable> parts = new ArrayList<>();
  private final CountDownLatch closing = new CountDownLatch(1);

  private final DemoCameras cameras = new DemoCameras();

  /** Where somebody is who walks on the first floor. */
  private volatile Vec2 walker = WALK_START;

  private BuildingScenario() throws IOException {
    parts.add(cameras);
  }

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
    SimulatedHttpRobot robot = new SimulatedHttpRobot(settings(token, start), surroundings);
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
    addCamera(
        toqa,
        new CameraOrder(name + "-front", URI.create("http://camera"), name, null),
        user,
        () -> view(toqa.fleet(), floor, robot.truePose(), name));
    if (floor.name().equals(FLOORS.getFirst())) {
      Pose post = new Pose(WATCH.x(), WATCH.y(), WALK_START.minus(WATCH).angle());
      addCamera(
          toqa,
          new CameraOrder(floor.name() + "-wall", URI.create("http://camera"), null, floor.name()),
          user,
          () -> view(toqa.fleet(), floor, post, ""));
      Thread.ofVirtual().name("walker").start(() -> walk(world));
    }
  }

  /** A robot that slips, whose place ranges correct, and that sees what is round it. */
  private static SimulatedHttpRobot.Settings settings(RobotToken token, Pose start) {
    SimulatedHttpRobot.Settings exact = SimulatedHttpRobot.Settings.of(token, start);
    return new SimulatedHttpRobot.Settings(
        exact.address(),
        exact.port(),
        token,
        null,
        null,
        start,
        SLIP,
        SIZE_ERROR,
        exact.seed(),
        MAX_LOAD,
        exact.delay(),
        RANGE_ANGLES,
        UltrasonicSensors.SONAR);
  }

  /**
   * @param order but for where it answers
   */
  private void addCamera(
      FleetServer toqa, CameraOrder order, String user, Supplier<BufferedImage> view) {
    URI url = cameras.add(order.name(), view);
    toqa.cameras().add(new CameraOrder(order.name(), url, order.robot(), order.floor()), user);
  }

  /**
   * What a camera sees: walls, robots, who walks there, and loads that wait or were set down.
   *
   * @param robot that the camera is on
   */
  private BufferedImage view(Fleet fleet, FloorMap floor, Pose camera, String robot) {
    FleetSnapshot snapshot = fleet.snapshots().latest();
    List<Standing> standing = new ArrayList<>();
    for (RobotView other : snapshot.robots()) {
      Pose pose = other.telemetry().pose();
      if (pose != null && other.floor().equals(floor.name()) && !other.name().equals(robot)) {
        standing.add(new Standing(pose.position(), FOOTPRINT / 2, ROBOT_HEIGHT, ROBOT_COLOUR));
      }
    }
    for (LoadView load : LoadView.of(snapshot)) {
      if (load.place() != null && load.floor().equals(floor.name())) {
        standing.add(new Standing(load.place().position(), LOAD_RADIUS, LOAD_HEIGHT, LOAD_COLOUR));
      }
    }
    if (floor.name().equals(FLOORS.getFirst())) {
      standing.add(new Standing(walker, WALKER_RADIUS, WALKER_HEIGHT, WALKER_COLOUR));
    }
    return SimulatedCamera.draw(floor.drawing().walls(), camera, standing);
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
        walker = at;
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
