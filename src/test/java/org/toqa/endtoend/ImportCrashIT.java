package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code kill -9} of a server that imports: all tasks of a table are there, or none. */
@Tag("full")
class ImportCrashIT {
  private static final int TASKS = 500;
  private static final int CRASHES = 5;

  @TempDir private Path folder;

  @Test
  void aServerThatIsKilledHasImportedAllOrNothing() throws Exception {
    try (RunningServer server = new RunningServer(folder)) {
      long before = 0;
      for (int crash = 0; crash < CRASHES; crash++) {
        String key = "table-" + crash;
        CompletableFuture<String> cutOff = server.api().sendTable("tasks/import", table(), key);
        for (int i = 0; i < 30 * crash * crash; i++) { // each time it is killed at another moment
          server.api().get("health");
        }
        server.killAndRestart();
        cutOff.handle((answer, failure) -> answer).get(30, TimeUnit.SECONDS);

        long there = server.api().count("tasks") - before;
        assertTrue(there == 0 || there == TASKS, there + " of " + TASKS);
        server.api().sendTable("tasks/import", table(), key).get(30, TimeUnit.SECONDS);
        before += TASKS;
        assertEquals(before, server.api().count("tasks"), "once, also when it is sent again");
      }
    }
  }

  private static String table() {
    return "name,load,start,goal\n" + "box,1,Mill,Store A\n".repeat(TASKS);
  }
}
