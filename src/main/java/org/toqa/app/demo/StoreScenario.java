package org.toqa.app.demo;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.toqa.app.server.FleetServer;
import org.toqa.app.server.WebappFolder;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.supervision.Supervision;
import org.toqa.fleet.supervision.SupervisionOrder;
import org.toqa.geometry.Vec2;

/**
 * CMCT as an ordinary part of Toqa: on the floor {@code store} a supervisor with cameras looks for
 * ten boxes, two workers with arms carry them, and there is one charging point fewer than robots.
 */
final class StoreScenario {
  private static final String FLOOR = "store";
  private static final List<String> WORKERS = List.of("r1", "r2");
  private static final String SUPERVISOR = "r3";
  private static final int READY_SECONDS = 60;

  /** Percent, robot by robot: all of them charge on the way. */
  static final String BATTERIES = "32,28,24";

  /** Percent up to which they charge: enough for what is left. */
  static final String CHARGE_UNTIL = "40";

  static final String ROBOTS = "3";

  private static final String PLACES =
      """
      stations:
        - {name: Lift, x: 16.05, y: 4.95}
      parking:
        - {name: S1, x: 16.05, y: 2.55}
        - {name: S2, x: 16.05, y: 1.65}
        - {name: S3, x: 16.05, y: 0.75}
      charging:
        - {name: Charge 1, x: 15.15, y: 2.55}
        - {name: Charge 2, x: 15.15, y: 1.35}
      """;

  /** A box, where it lies at first, what it weighs, and where it shall lie. */
  private record Box(int number, Vec2 place, double weight, Vec2 target) {}

  private static final List<Box> BOXES =
      List.of(
          box(1, 0.6, 7.9, 1.2, 15.0, 9.0),
          box(2, 3.25, 7.5, 2, 15.0, 8.4),
          box(3, 5.65, 6.6, 3, 15.0, 7.8),
          box(4, 8.05, 7.8, 1.5, 15.0, 7.2),
          box(5, 10.45, 7.2, 2.4, 15.0, 6.6),
          box(6, 0.6, 2.1, 1.8, 16.5, 9.0),
          box(7, 3.25, 2.4, 4, 16.5, 8.4),
          box(8, 13.35, 7.5, 8, 15.75, 6.0),
          box(9, 13.35, 2.1, 7, 15.75, 4.2),
          box(10, 10.45, 2.7, 3.2, 16.5, 7.8));

  private StoreScenario() {}

  private static Box box(int number, double x, double y, double weight, double toX, double toY) {
    return new Box(number, new Vec2(x, y), weight, new Vec2(toX, toY));
  }

  /**
   * The map, as the configuration names it.
   *
   * @param folder gets it
   */
  static String map(Path folder) throws IOException {
    Files.createDirectories(folder);
    Path shipped = WebappFolder.shippedMap().resolveSibling("");
    for (String file : List.of(FLOOR + ".yaml", FLOOR + ".pgm")) {
      Files.copy(shipped.resolve(file), folder.resolve(file));
    }
    Files.writeString(folder.resolve(FLOOR + ".floor.yaml"), PLACES);
    return folder.resolve(FLOOR + ".yaml").toString();
  }

  /**
   * The file of the simulated boxes, as the configuration names it.
   *
   * @param folder gets it
   */
  static String boxes(Path folder) throws IOException {
    StringBuilder text =
        new StringBuilder(
            "floor: %s%narms: [%s]%ncameras: [%s]%ncameraRange: 4%nboxes:%n"
                .formatted(FLOOR, String.join(", ", WORKERS), SUPERVISOR));
    for (Box box : BOXES) {
      text.append(
          String.format(
              Locale.ROOT,
              "  - {number: %d, x: %s, y: %s, weight: %s}%n",
              box.number(),
              box.place().x(),
              box.place().y(),
              box.weight()));
    }
    Path file = folder.resolve("store.boxes.yaml");
    Files.writeString(file, text);
    return file.toString();
  }

  /**
   * Waits until all robots are ready, and lets them begin.
   *
   * @param overlaps whether boxes are looked for while others are carried
   * @throws Exception they are not ready, or it is refused; the message says why
   */
  static void begin(FleetServer toqa, String user, boolean overlaps) throws Exception {
    awaitRobots(toqa);
    Map<Integer, Vec2> targets = new TreeMap<>();
    BOXES.forEach(box -> targets.put(box.number(), box.target()));
    Answer<Supervision> answer =
        toqa.supervisor()
            .start(new SupervisionOrder(FLOOR, SUPERVISOR, WORKERS, overlaps, targets), user)
            .toCompletableFuture()
            .get(READY_SECONDS, TimeUnit.SECONDS);
    if (!(answer instanceof Answer.Accepted<Supervision>)) {
      throw new IllegalStateException(answer.toString());
    }
  }

  private static void awaitRobots(FleetServer toqa) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(READY_SECONDS);
    FleetSnapshot snapshot = toqa.fleet().snapshots().latest();
    while (!areReady(snapshot)) {
      if (System.nanoTime() > end) {
        throw new IllegalStateException("The robots are not ready: " + snapshot.robots());
      }
      snapshot = toqa.fleet().snapshots().awaitNewer(snapshot.version(), Duration.ofMillis(250));
    }
  }

  /** Whether all work, and the supervisor has told what its cameras see. */
  private static boolean areReady(FleetSnapshot snapshot) {
    List<RobotView> robots = snapshot.robots();
    return robots.stream()
            .anyMatch(
                robot ->
                    robot.name().equals(SUPERVISOR)
                        && robot.telemetry().readings().camera() != null)
        && robots.stream().allMatch(robot -> robot.state().kind() == RobotState.Kind.OPERATIONAL);
  }

  /** Whether it has ended. */
  static boolean isOver(FleetServer toqa) {
    return toqa.supervisor().latest(FLOOR).filter(s -> !s.isRunning()).isPresent();
  }

  /** Whether every box lies at its target. */
  static boolean isDone(FleetServer toqa) {
    return toqa.supervisor()
        .latest(FLOOR)
        .filter(s -> s.state() == Supervision.State.DONE)
        .isPresent();
  }

  /**
   * What it came to, in a line.
   *
   * @param took in the time of the fleet
   */
  static String summary(FleetServer toqa, Duration took) {
    return toqa.supervisor()
        .latest(FLOOR)
        .map(
            s ->
                String.format(
                    Locale.ROOT,
                    "  %d boxes of %d at their targets; workers were idle %.1f s a box; it took %d s%n",
                    s.deliveredCount(),
                    s.boxes().size(),
                    s.idleSecondsPerBox().orElse(0.0),
                    took.toSeconds()))
        .orElse("");
  }
}
