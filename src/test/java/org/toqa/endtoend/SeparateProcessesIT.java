package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
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

  private static boolean areAllIdle(JsonNode robots) {
    for (JsonNode robot : robots) {
      if (!robot.get("state").asString().equals("IDLE")) {
        return false;
      }
    }
    return robots.size() == STARTS.size();
  }
}
