package org.toqa.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.StopSignal;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.app.server.FleetServer;
import org.toqa.app.server.ServerOperation;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.Place;
import org.toqa.sim.Body;
import org.toqa.sim.ClearanceJudge;
import org.toqa.sim.ClearanceJudge.Clearance;
import org.toqa.sim.Participant;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;
import org.toqa.testbed.ApiClient;
import org.toqa.web.WebTestServer;

/**
 * A whole server over HTTP, and robots that it does not know to be simulated: their real daemons
 * behind TCP ports, over wheels that turn. Server and wheels live by one clock, which waits for
 * whoever is slow; the world tells what is true.
 */
final class RoadWorld {
  static final String ROBOT = "r1";
  static final String MANAGER = "Max";
  static final Vec2 PARKING = new Vec2(13.35, 1.05); // P1 of the lab
  static final Vec2 GOODS_OUT = new Vec2(11.55, 1.05);

  private static final Path MAP = Path.of("maps", "lab.yaml");
  private static final Path WEBAPP = Path.of("target", "webapp").toAbsolutePath();
  private static final double SPEED = 10;

  /** Of the world's time. */
  private static final Duration LIMIT = Duration.ofMinutes(3);

  private static final Duration TRACK_PERIOD = Duration.ofMillis(100);
  private static final long LOOK_AGAIN_NANOS = 5_000_000;

  private final FleetServer toqa;
  private final URI address;
  private final ApiClient api;
  private final VirtualClock clock;
  private final SimulatedFleet robots;
  private final List<Pose> track = new CopyOnWriteArrayList<>();
  private final ClearanceJudge truth;

  /** What a test does on the road. */
  @FunctionalInterface
  interface Walk {
    void walk(RoadWorld road) throws Exception;
  }

  /** What is waited for. */
  @FunctionalInterface
  interface Condition {
    boolean isSatisfied() throws Exception;
  }

  private RoadWorld(
      FleetServer toqa, URI address, ApiClient api, SimulatedFleet robots, FloorMap lab) {
    this.toqa = toqa;
    this.address = address;
    this.api = api;
    this.clock = toqa.fleetClock();
    this.robots = robots;
    truth = new ClearanceJudge(lab.grid());
  }

  /**
   * Starts robots and server, makes them known to each other, and walks. No body has touched
   * another one or a wall meanwhile, where they really were.
   *
   * @param bodies the first one is {@link #ROBOT}; each is at home at the parking point of its turn
   */
  static void walk(Path folder, List<SimulatedRobot> bodies, Walk walk) throws Exception {
    FloorMap lab = FloorReader.read(MAP);
    ServerOperation operation =
        (toqa, address, _) -> {
          walk(toqa, address, folder, lab, bodies, walk);
          return 0;
        };
    try (StopSignal stop = new StopSignal()) {
      assertEquals(0, operation.runWith(configuration(folder), WEBAPP, stop));
    }
  }

  private static void walk(
      FleetServer toqa,
      URI address,
      Path folder,
      FloorMap lab,
      List<SimulatedRobot> bodies,
      Walk walk)
      throws Exception {
    VirtualClock clock = toqa.fleetClock();
    try (ApiClient api = new ApiClient(address, MANAGER, WebTestServer.PASSWORD);
        SimulatedFleet robots =
            SimulatedFleet.open(folder.resolve("robots"), bodies, SimulatedFloor.of(lab), clock)) {
      RoadWorld road = new RoadWorld(toqa, address, api, robots, lab);
      Participant look = road::look;
      clock.add(look, VirtualClock.STEP);
      for (int i = 0; i < bodies.size(); i++) {
        road.addRobot(bodies.get(i), lab.parking().get(i));
      }
      walk.walk(road);
      clock.remove(look);
      road.assertClear();
    }
  }

  private static Configuration configuration(Path folder) throws Exception {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(Setting.PORT, "0");
    options.put(Setting.DATA, folder.resolve("data").toString());
    options.put(Setting.MANAGER, MANAGER + ":" + WebTestServer.PASSWORD_HASH);
    options.put(Setting.LOG_LEVEL, "ERROR");
    return faster(Configuration.of(MAP, List.of(SettingSource.fromCommandLine(options))));
  }

  /** What no setting allows: it does not know that its robots live as fast as its clock. */
  private static Configuration faster(Configuration usual) {
    return new Configuration(
        usual.address(),
        usual.port(),
        usual.hosts(),
        usual.tls(),
        usual.proxy(),
        usual.requestsPerSecond(),
        usual.limits(),
        usual.sessionLimit(),
        usual.data(),
        usual.maps(),
        usual.shippedMap(),
        usual.database(),
        usual.allocationPolicy(),
        usual.simulatedRobots(),
        usual.simulatedBatteries(),
        usual.simulatedAvoidance(),
        usual.simulatedBoxes(),
        usual.firmware(),
        usual.widestRobot(),
        usual.margins(),
        usual.reassignAfter(),
        usual.charging(),
        SPEED,
        usual.trackRetention(),
        usual.historyRetention(),
        usual.firstManager(),
        usual.mailServer(),
        usual.webhooks(),
        usual.plainLinks(),
        usual.gateways(),
        usual.broker(),
        usual.dhcp(),
        usual.logLevel(),
        usual.logFormat(),
        usual.settings());
  }

  private void addRobot(SimulatedRobot body, Place parking)
      throws IOException, InterruptedException {
    api.post(
        "robots",
        Map.of(
            "name", body.name(),
            "host", "127.0.0.1",
            "port", robots.port(body.name()),
            "maxLoad", body.maxLoad(),
            "parking", parking.name()));
  }

  private void look(long nanos) {
    judge(Duration.ofNanos(nanos), robots.bodies("lab"));
    if (nanos % TRACK_PERIOD.toNanos() == 0) {
      robots.truePose(ROBOT).ifPresent(track::add);
    }
  }

  /** Looks at bodies of whose places only the test knows, too. */
  void judge(Duration at, List<Body> bodies) {
    truth.judge(at, bodies);
  }

  private void assertClear() {
    assertTrue(truth.samples() > 0);
    truth.betweenBodies().ifPresent(nearest -> assertFalse(nearest.isTouch(), nearest::toString));
    Clearance wall = truth.toWall().orElseThrow();
    assertFalse(wall.isTouch(), wall::toString);
  }

  /** Of the pages, with a slash at its end. */
  URI address() {
    return address;
  }

  ApiClient api() {
    return api;
  }

  /** The world's time. */
  VirtualClock clock() {
    return clock;
  }

  /** Of the newest snapshot that the fleet has made. */
  long publishedVersion() {
    return toqa.fleet().snapshots().latest().version();
  }

  /** Where the wheels have taken the robot, from the first on, every 0.1 s. */
  List<Pose> track() {
    return List.copyOf(track);
  }

  /** Metres from where the robot really is now. */
  double distanceTo(Vec2 point) {
    return track.isEmpty()
        ? Double.POSITIVE_INFINITY
        : track.getLast().position().distanceTo(point);
  }

  /** Whether the world has gone on for longer than anything on this road takes. */
  boolean isLate() {
    return clock.nanos() > LIMIT.toNanos();
  }

  /** Waits until it is so, while the world goes on. */
  void await(String what, Condition condition) throws Exception {
    long end = clock.nanos() + LIMIT.toNanos();
    while (!condition.isSatisfied()) {
      if (clock.nanos() > end) {
        fail("Not " + what + "; the fleet: " + api.get("robots") + api.get("tasks"));
      }
      LockSupport.parkNanos(LOOK_AGAIN_NANOS);
    }
  }

  /** Lets so much of the world's time pass. */
  void pass(Duration time) {
    long end = clock.nanos() + time.toNanos();
    while (clock.nanos() < end) {
      LockSupport.parkNanos(LOOK_AGAIN_NANOS);
    }
  }
}
