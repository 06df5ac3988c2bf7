package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;

/** Programs in another language that were written from docs/robot-link.md alone. */
@Tag("full")
class ForeignProgramsIT {
  private static final Path PROGRAMS = Path.of("src/test/outsider").toAbsolutePath();

  @TempDir private Path folder;

  @Test
  void serverDrivesAForeignRobot() throws Exception {
    try (ToqaProcess robot = program("robot.py", "foreign", "2.55", "10.65");
        RunningServer server = new RunningServer(folder)) {
      int port = Integer.parseInt(robot.awaitErr("\\d+").group());
      Map<String, Object> order =
          Map.of("name", "foreign", "host", "127.0.0.1", "port", port, "maxLoad", 5);
      server.api().post("robots", order);
      long task = server.addTask("box", "Workbench 2", "Mill");

      server.awaitState(task, "RETURNING");

      JsonNode pose = server.await("robots/foreign", r -> true).get("pose");
      assertTrue(Math.hypot(pose.get("x").asDouble() - 3.45, pose.get("y").asDouble() - 9.45) < 1);
      assertEquals(1, server.eventCount(task, "Picked up"));
      assertEquals(1, server.eventCount(task, "Delivered"));
    }
  }

  @Test
  void foreignServerDrivesARobot() throws Exception {
    try (RunningAgent robot = new RunningAgent(folder, "r1", 2, 1, 1);
        ToqaProcess server = program("server.py", String.valueOf(robot.port()))) {
      assertEquals(0, server.exitCode(), () -> String.join("\n", errors(server)));
      double[] end =
          Arrays.stream(server.out().getFirst().split(" "))
              .mapToDouble(Double::parseDouble)
              .toArray();
      assertEquals(3, end[0], 0.01);
      assertEquals(1, end[1], 0.01);
    }
  }

  private ToqaProcess program(String name, String... arguments) throws Exception {
    List<String> command = new ArrayList<>(List.of("python3"));
    command.add(PROGRAMS.resolve(name).toString());
    command.addAll(List.of(arguments));
    return ToqaProcess.command(folder, command.toArray(String[]::new));
  }

  private static List<String> errors(ToqaProcess process) {
    try {
      return process.err();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return List.of();
    }
  }
}
