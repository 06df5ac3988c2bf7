package org.toqa.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.StopSignal;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.app.server.ServerOperation;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;
import org.toqa.testbed.ApiClient;
import org.toqa.web.WebTestServer;

/**
 * A whole server over HTTP, and one robot that it does not know to be simulated: its real daemon
 * behind a TCP port, over wheels that turn in a world of their own. The world tells what is true.
 */
final class RoadWorld {
  static final String ROBOT = "r1";
  static final String MANAGER = "Max";
  static final Vec2 PARKING = new Vec2(13.35, 1.05); // P1 of the lab
  static final Vec2 GOODS_OUT = new Vec2(11.55, 1.05);

  private static final Path MAP = Path.of("maps", "lab.yaml");
  private static final Path WEBAPP = Path.of("target", "webapp").toAbsolutePath();

  /** Of the world's time, which a slow machine slows. */
  private static final Duration LIMIT = Duration.ofMinutes(2);

  private static final long LOOK_AGAIN_NANOS = 5_000_000;

  private final URI address;
  private final ApiClient api;
  private final VirtualClock clock;
  private final List<Pose> track;

  /** What a test does on the road. */
  @FunctionalInterface
  interface Walk {
    void walk(RoadWorld road) throws Exception;
  }

  private RoadWorld(URI address, ApiClient api, VirtualClock clock, List<Pose> track) {
    this.address = address;
    this.api = api;
    this.clock = clock;
    this.track = track;
  }

  /**
   * Starts robot and server, makes them known to each other, and walks.
   *
   * @param start where the robot is at first
   */
  static void walk(Path folder, Pose start, Walk walk) throws Exception {
    FloorMap lab = FloorReader.read(MAP);
    List<Pose> track = new CopyOnWriteArrayList<>();
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 1);
        SimulatedFleet robots =
            SimulatedFleet.open(
                folder.resolve("robots"),
                List.of(new SimulatedRobot(ROBOT, start, 5, 1)),
                SimulatedFloor.of(lab),
                clock);
        StopSignal stop = new StopSignal()) {
      clock.add(nanos -> robots.truePose(ROBOT).ifPresent(track::add), Duration.ofMillis(100));
      clock.start();
      ServerOperation operation =
          (toqa, address, _) -> {
            try (ApiClient api = new ApiClient(address, MANAGER, WebTestServer.PASSWORD)) {
              walk.walk(new RoadWorld(address, api, clock, track).with(robots.port(ROBOT)));
            }
            return 0;
          };
      assertEquals(0, operation.runWith(configuration(folder), WEBAPP, stop));
    }
  }

  private static Configuration configuration(Path folder) throws Exception {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(Setting.PORT, "0");
    options.put(Setting.DATA, folder.resolve("data").toString());
    options.put(Setting.MANAGER, MANAGER + ":" + WebTestServer.PASSWORD);
    options.put(Setting.LOG_LEVEL, "ERROR");
    return Configuration.of(MAP, List.of(SettingSource.fromCommandLine(options)));
  }

  private RoadWorld with(int port) throws Exception {
    api.post(
        "robots",
        Map.of("name", ROBOT, "host", "127.0.0.1", "port", port, "maxLoad", 5, "parking", "P1"));
    return this;
  }

  /** Of the pages, with a slash at its end. */
  URI address() {
    return address;
  }

  ApiClient api() {
    return api;
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
  void await(String what, BooleanSupplier condition) {
    long end = clock.nanos() + LIMIT.toNanos();
    while (!condition.getAsBoolean()) {
      if (clock.nanos() > end) {
        fail("Not " + what + "; the robot is at " + track.getLast());
      }
      LockSupport.parkNanos(LOOK_AGAIN_NANOS);
    }
  }
}
