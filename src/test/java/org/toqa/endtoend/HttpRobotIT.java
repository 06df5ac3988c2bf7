package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;

/** Robots that take wheel commands over HTTP, each a process, like any other robot of a server. */
@Tag("full")
class HttpRobotIT {
  private static final String TOKEN = "a-token-of-a-test";
  private static final Path PROGRAMS = Path.of("src/test/outsider").toAbsolutePath();

  @TempDir private Path folder;

  @Test
  void serverAndRobotAreKilledInTheMiddleOfATask() throws Exception {
    try (RunningServer server = new RunningServer(folder);
        ToqaProcess first = robot(0)) {
      int port = port(first);
      add(server, port);
      locate(server, 10.65, 3.15);
      long task = server.addTask("crate", "Packing 2", "Packing 1");
      server.awaitState(task, "TO_OBJECT");

      server.killAndRestart();
      server.awaitState(task, "CARRYING");
      first.kill();
      server.await("robots/h1", robot -> robot.get("state").asString().equals("LOST"));
      try (ToqaProcess second = robot(port)) {
        assertEquals(port, port(second));
        server.awaitState(task, "DONE");
      }

      assertEquals(1, server.eventCount(task, "Picked up"), "picked up: " + server.task(task));
      assertEquals(1, server.eventCount(task, "Delivered"), "delivered: " + server.task(task));
      server.stop();
      List<String> log = server.errorOutput();
      assertFalse(log.stream().anyMatch(line -> line.contains(TOKEN)), "the token is logged");
    }
  }

  @Test
  void strangersRobotCarriesALoad() throws Exception {
    String program = PROGRAMS.resolve("http_robot.py").toString();
    try (RunningServer server = new RunningServer(folder);
        ToqaProcess robot = ToqaProcess.command(folder, "python3", program, TOKEN)) {
      add(server, Integer.parseInt(robot.awaitErr("\\d+").group()));
      locate(server, 10.65, 3.15);

      long task = server.addTask("crate", "Packing 2", "Packing 1");
      server.awaitState(task, "RETURNING");

      JsonNode pose = server.await("robots/h1", r -> true).get("pose");
      assertTrue(Math.hypot(pose.get("x").asDouble() - 7.95, pose.get("y").asDouble() - 3.75) < 1);
      // what is seen can be a moment ahead of what is stored
      server.await("tasks/" + task, t -> RunningServer.eventCount(t, "Delivered") == 1);
    }
  }

  @Test
  void wrongTokenIsToldAndReplaced() throws Exception {
    try (RunningServer server = new RunningServer(folder);
        ToqaProcess robot = robot(0)) {
      Map<String, Object> order = order(port(robot));
      order.put("token", "this-is-not-the-token");
      JsonNode added = server.api().post("robots", order);
      assertFalse(added.toString().contains("this-is-not"), added.toString());
      server.await(
          "robots/h1",
          r -> r.get("unreachable").asString("").contains("does not accept this server’s token"));

      Map<String, Object> change = new HashMap<>(order(port(robot)));
      List.of("name", "link").forEach(change::remove);
      server.api().put("robots/h1", change);

      server.await("robots/h1", r -> r.get("state").asString().equals("NOT_LOCALISED"));
    }
  }

  private ToqaProcess robot(int port) throws Exception {
    return ToqaProcess.program(
        folder,
        "http-robot",
        "--port",
        String.valueOf(port),
        "--token",
        TOKEN,
        "--data",
        folder.resolve("robot").toString());
  }

  private static int port(ToqaProcess robot) throws InterruptedException {
    return Integer.parseInt(robot.awaitErr("Listening on .* port (\\d+)").group(1));
  }

  private static Map<String, Object> order(int port) {
    return new HashMap<>(
        Map.of(
            "name",
            "h1",
            "host",
            "127.0.0.1",
            "port",
            port,
            "maxLoad",
            5,
            "link",
            "http",
            "token",
            TOKEN));
  }

  private static void add(RunningServer server, int port) throws Exception {
    server.api().post("robots", order(port));
    server.await("robots/h1", robot -> robot.get("state").asString().equals("NOT_LOCALISED"));
  }

  private static void locate(RunningServer server, double x, double y) throws Exception {
    server.api().post("robots/h1/locate", Map.of("x", x, "y", y, "theta", 0));
    server.await("robots/h1", robot -> robot.get("state").asString().equals("IDLE"));
  }
}
