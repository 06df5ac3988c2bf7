package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.RealMySql;
import tools.jackson.databind.JsonNode;

/** A server on a real MySQL, and three daemons, each a process of its own; each is killed. */
@Tag("full")
class SeparateProcessesIT {
  private static final Map<String, double[]> STARTS =
      Map.of(
          "carl", new double[] {7.95, 3.15},
          "dora", new double[] {14.25, 1.05},
          "emil", new double[] {15.15, 1.05});

  private static final double SPEED = 12;

  /** In the zone it must be seen before it has left it. */
  private static final double SPEED_IN_HALL = 4;

  /** Whether a zone is freed by a person too. */
  private static final boolean IS_LONG = "whole".equals(System.getProperty("toqa.walk"));

  @TempDir private Path folder;

  private final Map<String, RunningAgent> agents = new HashMap<>();

  @Test
  void serverAndAgentAreKilledInEveryPhase() throws Exception {
    Path config = folder.resolve("server.yaml");
    Files.writeString(config, "database:\n  url: \"" + RealMySql.newDatabase() + "\"\n");
    try (RunningServer server = new RunningServer(folder, "--config", config.toString())) {
      for (String name : STARTS.keySet().stream().sorted().toList()) {
        double[] start = Objects.requireNonNull(STARTS.get(name));
        RunningAgent agent = new RunningAgent(folder, name, start[0], start[1], 1);
        agents.put(name, agent);
        server
            .api()
            .post(
                "robots",
                Map.of("name", name, "host", "127.0.0.1", "port", agent.port(), "maxLoad", 5));
      }
      server.await("robots", SeparateProcessesIT::areAllIdle);

      long task = server.addTask("crate", "Packing 1", "Packing 2");
      server.awaitState(task, "TO_OBJECT");
      server.killAndRestart();
      server.awaitState(task, "CARRYING");
      server.killAndRestart();

      String carrier = server.task(task).get("robots").get(0).asString();
      Objects.requireNonNull(agents.get(carrier)).kill();
      server.await("robots/" + carrier, r -> r.get("state").asString().equals("LOST"));
      assertEquals("CARRYING", server.state(task));
      Objects.requireNonNull(agents.get(carrier)).start();

      server.awaitState(task, "RETURNING");
      server.killAndRestart();
      server.awaitState(task, "DONE");
      assertEquals(1, server.eventCount(task, "Picked up"));
      assertEquals(1, server.eventCount(task, "Delivered"));
    } finally {
      agents.values().forEach(RunningAgent::close);
    }
  }

  /** The zone fills the hall from wall to wall: nobody gets past who died in it. */
  @Test
  void theFreeZoneOfADaemonThatWasKilledInItStaysItsOwnUntilItIsHeardOrOutOfService()
      throws Exception {
    try (RunningAgent dead =
            new RunningAgent(
                folder,
                "zed",
                0.75,
                2.85,
                SPEED_IN_HALL,
                "",
                "kind: differential\navoidance: four-agents\n");
        RunningServer server = startInHall()) {
      server
          .api()
          .post(
              "robots",
              Map.of("name", "zed", "host", "127.0.0.1", "port", dead.port(), "maxLoad", 5));
      server.await("robots", robots -> robots.size() == 2 && areIdle(robots));

      long crossing = crossing(server, "zed", "West", "East");
      long waiting = killInTheZone(server, dead, crossing);
      dead.start();
      server.awaitState(crossing, "DONE");
      server.awaitState(waiting, "DONE");

      if (IS_LONG) {
        crossing = crossing(server, "zed", "East", "West");
        waiting = killInTheZone(server, dead, crossing);
        server.api().post("robots/zed/out-of-service", Map.of());
        server.awaitState(waiting, "DONE");
      }
    }
  }

  /** With a simulated robot, {@code r1}. */
  private RunningServer startInHall() throws Exception {
    String wall = "0 ".repeat(29).strip() + "\n";
    String row = "0 " + "1 ".repeat(27) + "0\n";
    Files.writeString(folder.resolve("hall.pgm"), "P2\n29 12\n1\n" + wall + row.repeat(10) + wall);
    Files.writeString(
        folder.resolve("hall.yaml"),
        """
        image: hall.pgm
        resolution: 0.30
        origin: [0.0, 0.0, 0.0]
        negate: 0
        occupied_thresh: 0.65
        free_thresh: 0.196
        """);
    Files.writeString(
        folder.resolve("hall.floor.yaml"),
        """
        stations:
          - {name: West, x: 1.35, y: 1.65}
          - {name: East, x: 7.65, y: 1.65}
        parking:
          - {name: P1, x: 0.75, y: 0.75}
          - {name: P2, x: 0.75, y: 2.85}
        freeZones:
          - {x: 2.7, y: 0.3, width: 3.3, height: 3}
        """);
    Files.writeString(
        folder.resolve("hall-server.yaml"),
        "map: %s\nlostAfter: 5\n".formatted(folder.resolve("hall.yaml")));
    return new RunningServer(
        folder,
        "--config",
        folder.resolve("hall-server.yaml").toString(),
        "--simulate",
        "1",
        "--speed",
        String.valueOf(SPEED_IN_HALL));
  }

  private static long crossing(RunningServer server, String robot, String from, String to)
      throws Exception {
    Map<String, Object> order = new HashMap<>(RunningServer.order("crate", from, to));
    order.put("onlyRobots", List.of(robot));
    return server.api().post("tasks", order).get("id").asLong();
  }

  /** As soon as it is well in the zone; the task of another one, which waits before it then. */
  private static long killInTheZone(RunningServer server, RunningAgent dead, long crossing)
      throws Exception {
    server.awaitState(crossing, "CARRYING");
    server.await("robots/zed", zed -> Math.abs(x(zed) - 4.35) < 1);
    dead.kill();
    server.await("robots/zed", zed -> zed.get("state").asString().equals("LOST"));
    server.api().awaitSnapshot(snapshot -> kept(snapshot) > 100); // of 110 cells of the zone

    long waiting = crossing(server, "r1", "West", "East");
    server.api().awaitSnapshot(snapshot -> isWaitingBefore(snapshot, waiting));
    return waiting;
  }

  private static double x(JsonNode robot) {
    return robot.get("pose").get("x").asDouble();
  }

  private static int kept(JsonNode snapshot) {
    int cells = 0;
    for (JsonNode kept : snapshot.get("floors").get(0).get("kept")) {
      for (int i = 1; i < kept.get("cells").size(); i += 2) {
        cells += kept.get("cells").get(i).asInt();
      }
    }
    return cells;
  }

  private static boolean isWaitingBefore(JsonNode snapshot, long task) {
    boolean isOutside =
        snapshot
            .get("robots")
            .valueStream()
            .filter(robot -> robot.get("name").asString().equals("r1"))
            .allMatch(robot -> x(robot) < 2.7);
    assertTrue(isOutside, () -> "in the zone of another one: " + snapshot.get("robots"));
    return snapshot
        .get("tasks")
        .valueStream()
        .filter(view -> view.get("id").asLong() == task)
        .anyMatch(view -> view.toString().contains("zed"));
  }

  private static boolean areIdle(JsonNode robots) {
    return robots.valueStream().allMatch(robot -> robot.get("state").asString().equals("IDLE"));
  }

  private static boolean areAllIdle(JsonNode robots) {
    for (JsonNode robot : robots) {
      if (!robot.get("state").asString().equals("IDLE")) {
        return false;
      }
    }
    return robots.size() == STARTS.size();
  }
}
