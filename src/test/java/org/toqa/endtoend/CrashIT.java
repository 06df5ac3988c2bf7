package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code kill -9} of a server with simulated robots: no task is lost, none is done twice. */
@Tag("full")
class CrashIT {
  private static final List<String> STATIONS =
      List.of("Goods-in 1", "Mill", "Store A", "Assembly", "Packing 1");

  private static final int MOST_TASKS = 20;

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
        server.killAndRestart();
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
