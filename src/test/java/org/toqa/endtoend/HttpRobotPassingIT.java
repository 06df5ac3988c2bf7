package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.robot.SimulatedHttpRobot;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorReader;
import org.toqa.link.http.RobotToken;
import org.toqa.sim.SimulatedFloor;

/**
 * A robot over HTTP with range sensors carries something through a hall of a whole server, in which
 * something small stands on its path; judged by where its body really is.
 */
@Tag("full")
class HttpRobotPassingIT {
  private static final RobotToken TOKEN = new RobotToken("0123456789abcdef");
  private static final Pose START = new Pose(0.75, 0.75, 0);
  private static final Vec2 THING = new Vec2(4.5, 1.65);
  private static final double THING_RADIUS = 0.05;
  private static final double ROBOT_RADIUS = 0.1275;
  private static final long SAMPLE_MILLIS = 20;
  private static final List<Double> ANGLES =
      Stream.of(-90, -50, -25, -10, 0, 10, 25, 50, 90).map(Math::toRadians).toList();

  @TempDir private Path folder;
  private volatile double nearest = Double.POSITIVE_INFINITY;

  @Test
  void drivesRoundInRoomThatItIsLentAndDelivers() throws Exception {
    Path map = hall();
    SimulatedFloor world = SimulatedFloor.of(FloorReader.read(map));
    SimulatedHttpRobot.Settings settings = settings();
    try (ScheduledExecutorService watch = Executors.newScheduledThreadPool(1);
        SimulatedHttpRobot robot =
            new SimulatedHttpRobot(settings, world.surroundings("h1", ROBOT_RADIUS));
        RunningServer server = new RunningServer(folder, "--map", map.toString())) {
      world.putObstacle("thing", THING, THING_RADIUS);
      var watching =
          watch.scheduleAtFixedRate(
              () -> look(robot.truePose()), 0, SAMPLE_MILLIS, TimeUnit.MILLISECONDS);
      server
          .api()
          .post(
              "robots",
              Map.of(
                  "name",
                  "h1",
                  "host",
                  "127.0.0.1",
                  "port",
                  robot.port(),
                  "maxLoad",
                  5,
                  "link",
                  "http",
                  "token",
                  TOKEN.secret()));
      server.await("robots/h1", r -> r.get("state").asString().equals("NOT_LOCALISED"));
      server
          .api()
          .post("robots/h1/locate", Map.of("x", START.x(), "y", START.y(), "theta", START.theta()));

      long task = server.addTask("crate", "West", "East");
      server.awaitErr("h1: is lent room to drive round what it sees at");
      server.awaitState(task, "DONE");
      watching.cancel(false);
    }
    assertTrue(nearest > 0, "touched it: " + nearest);
    assertTrue(nearest < 0.4, "was never beside it: " + nearest);
  }

  private void look(Pose robot) {
    nearest = Math.min(nearest, robot.position().distanceTo(THING) - THING_RADIUS - ROBOT_RADIUS);
  }

  private static SimulatedHttpRobot.Settings settings() {
    SimulatedHttpRobot.Settings usual = SimulatedHttpRobot.Settings.of(TOKEN, START);
    return new SimulatedHttpRobot.Settings(
        usual.address(), 0, TOKEN, null, null, START, 0, 0, 1, 5, Duration.ZERO, ANGLES, null);
  }

  /** 8.7 m by 3.6 m, with a station at each end. */
  private Path hall() throws Exception {
    String wall = "0 ".repeat(29).strip() + "\n";
    String row = "0 " + "1 ".repeat(27) + "0\n";
    Files.writeString(folder.resolve("hall.pgm"), "P2\n29 12\n1\n" + wall + row.repeat(10) + wall);
    Files.writeString(
        folder.resolve("hall.floor.yaml"),
        """
        stations:
          - {name: West, x: 1.35, y: 1.65}
          - {name: East, x: 7.65, y: 1.65}
        parking:
          - {name: P1, x: 0.75, y: 0.75}
        """);
    return Files.writeString(
        folder.resolve("hall.yaml"),
        """
        image: hall.pgm
        resolution: 0.30
        origin: [0.0, 0.0, 0.0]
        negate: 0
        occupied_thresh: 0.65
        free_thresh: 0.196
        """);
  }
}
