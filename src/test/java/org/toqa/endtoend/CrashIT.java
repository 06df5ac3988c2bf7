package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * {@code kill -9} of a server with simulated robots: no task is lost, none is done twice, and loads
 * that were set down in the only doors to a room keep robots out of it, with that reason.
 */
@Tag("full")
class CrashIT {
  private static final List<String> STATIONS =
      List.of("Goods-in 1", "Mill", "Store A", "Assembly", "Packing 1");

  private static final int MOST_TASKS = 20;

  /** The ways into the room with the mill: a door of 0.9 m, and one of 0.3 m. */
  private static final List<Map<String, Object>> DOORS =
      List.of(Map.of("x", 3.15, "y", 7.65), Map.of("x", 6.75, "y", 9.15));

  @TempDir private Path folder;

  @Test
  void aKilledServerGoesOnInEveryPhase() throws Exception {
    try (RunningServer server = new RunningServer(folder, "--simulate", "3", "--speed", "20")) {
      List<Long> tasks = new ArrayList<>();
      List<String> phases = List.of("", "TO_OBJECT", "CARRYING", "RETURNING");
      for (int i = 0; i < phases.size(); i++) {
        String name = "crash " + i;
        tasks.add(server.addTask(name, STATIONS.get(i), STATIONS.get(i + 1)));
        // else right after the answer 201
        while (!phases.get(i).isEmpty() && !isSeenIn(phases.get(i), tasks.getLast(), server)) {
          assertTrue(tasks.size() < MOST_TASKS, () -> "hardly a phase was seen of " + tasks);
          tasks.add(server.addTask(name, STATIONS.get(i), STATIONS.get(i + 1)));
        }
        List<Long> left = i == phases.size() - 1 ? setDownInTheDoors(server) : List.of();
        server.killAndRestart();
        if (!left.isEmpty()) {
          assertRobotsWaitForTheLoads(left, server);
        }
      }
      long first = tasks.getFirst();
      assertEquals(LongStream.range(first, first + tasks.size()).boxed().toList(), tasks);
      for (long task : tasks) {
        server.awaitState(task, "DONE");
        assertEquals(1, server.eventCount(task, "Picked up"), "picked up: " + server.task(task));
        assertEquals(1, server.eventCount(task, "Delivered"), "delivered: " + server.task(task));
      }
    }
  }

  @Test
  void aKilledServerLeavesEveryStopOfATourOnceAndInOrder() throws Exception {
    try (RunningServer server = new RunningServer(folder, "--simulate", "2", "--speed", "20")) {
      Map<String, Object> order = new HashMap<>(RunningServer.order("tour", "Store A", "Mill"));
      order.keySet().removeAll(List.of("start", "goal"));
      order.put(
          "stops",
          List.of(
              Map.of("station", "Store A"),
              Map.of("station", "Mill", "waitForPerson", true),
              Map.of("station", "Assembly", "waitSeconds", 2),
              Map.of("station", "Store A")));
      long task = server.api().post("tasks", order).get("id").asLong();
      server.await(
          "tasks/" + task, t -> t.get("stops").get(1).get("state").asString().equals("HERE"));
      server.killAndRestart();
      server.awaitAccepted("tasks/" + task + "/go-on", Map.of("stop", 2));
      server.killAndRestart();
      server.awaitState(task, "DONE");

      for (String once :
          List.of(
              "Picked up",
              "Waits at Mill",
              "Leaves Mill",
              "Leaves Assembly",
              "Delivered at Store")) {
        assertEquals(1, server.eventCount(task, once), once + ": " + server.task(task));
      }
    }
  }

  /** Loads past which no robot gets there; their tasks. */
  private static List<Long> setDownInTheDoors(RunningServer server) throws Exception {
    Map<String, Object> order =
        new HashMap<>(RunningServer.order("set down", "Packing 2", "Goods-in 1"));
    order.put("size", Map.of("length", 0.6, "width", 0.5));
    List<Long> tasks = new ArrayList<>();
    for (int i = 0; i < DOORS.size(); i++) {
      order.put("load", 1 + i); // the next one would fetch one like it where it is set down
      tasks.add(server.api().post("tasks", order).get("id").asLong());
    }
    for (int i = 0; i < DOORS.size(); i++) {
      String task = "tasks/" + tasks.get(i);
      server.awaitState(tasks.get(i), "CARRYING");
      server.awaitAccepted(task + "/cancel", Map.of("load", "here"));
      server.awaitState(tasks.get(i), "CANCELLED");
      server.awaitAccepted(task + "/load-moved", Map.of("place", DOORS.get(i)));
    }
    return tasks;
  }

  private static void assertRobotsWaitForTheLoads(List<Long> left, RunningServer server)
      throws Exception {
    long into = server.addTask("into the room", "Packing 1", "Mill");
    server.await(
        "tasks/" + into,
        task -> {
          assertNotEquals("DONE", task.get("state").asString());
          return task.get("waitingFor").asString("").contains("an obstacle");
        });
    for (long task : left) {
      server.awaitAccepted("tasks/" + task + "/load-removed", Map.of());
    }
    server.awaitState(into, "DONE");
  }

  /** Whether the task is in that phase now; false where the phase has passed unseen. */
  private static boolean isSeenIn(String phase, long task, RunningServer server) throws Exception {
    List<String> states = List.of(phase, "DONE");
    return server
        .await("tasks/" + task, t -> states.contains(t.get("state").asString()))
        .get("state")
        .asString()
        .equals(phase);
  }
}
