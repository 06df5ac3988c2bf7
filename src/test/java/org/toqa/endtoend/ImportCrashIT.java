package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ApiClient;
import org.toqa.testbed.ApiClient.Reply;

/**
 * {@code kill -9} of a server that imports, and of one that deletes a user who imports: all tasks
 * of a table are there, or none, and none of a deleted user's is open.
 */
@Tag("full")
class ImportCrashIT {
  private static final int TASKS = 500;
  private static final int CRASHES = 5;
  private static final String IMPORTED = "tasks?user=" + RunningServer.MANAGER;
  private static final String CLERK_PASSWORD = "clara-of-the-yard";
  private static final String DELETION = "users/%d?tasks=cancel&load=here";

  @TempDir private Path folder;

  @Test
  void aServerThatIsKilledHasImportedAllOrNothing() throws Exception {
    try (RunningServer server = new RunningServer(folder)) {
      long before = 0;
      for (int crash = 0; crash < CRASHES; crash++) {
        String key = "table-" + crash;
        long clerk = addUser(server.api(), "Clara");
        ApiClient clara = server.api().as("Clara", CLERK_PASSWORD);
        assertFalse(clara.sendTable("tasks/import", table(10), key).get().isEmpty());
        CompletableFuture<String> more = clara.sendTable("tasks/import", table(200), "more-" + key);
        CompletableFuture<Reply> deletion = server.api().deleteLater(DELETION.formatted(clerk));
        CompletableFuture<String> cutOff =
            server.api().sendTable("tasks/import", table(TASKS), key);
        for (int i = 0; i < 30 * crash * crash; i++) { // each time it is killed at another moment
          server.api().get("health");
        }
        server.killAndRestart();
        cutOff.handle((answer, failure) -> answer).get(30, TimeUnit.SECONDS);

        deletion.handle((answer, failure) -> answer).get(30, TimeUnit.SECONDS);
        more.handle((answer, failure) -> answer).get(30, TimeUnit.SECONDS);
        clara.close();
        assertNothingIsLeftOpen(server.api(), clerk);
        long there = server.api().count(IMPORTED) - before;
        assertTrue(there == 0 || there == TASKS, there + " of " + TASKS);
        server.api().sendTable("tasks/import", table(TASKS), key).get(30, TimeUnit.SECONDS);
        before += TASKS;
        assertEquals(before, server.api().count(IMPORTED), "once, also when it is sent again");
      }
    }
  }

  private static long addUser(ApiClient api, String name) throws Exception {
    return api.post("users", Map.of("name", name, "password", CLERK_PASSWORD)).get("id").asLong();
  }

  /** Either he is deleted with all that was his, or he is deleted now. */
  private static void assertNothingIsLeftOpen(ApiClient api, long clerk) throws Exception {
    Reply deleted = api.delete(DELETION.formatted(clerk));
    assertTrue(deleted.isAccepted() || deleted.status() == 404, () -> deleted.body().toString());
    assertEquals(0, api.count("tasks?state=open&user=Clara"));
  }

  private static String table(int tasks) {
    return "name,load,start,goal\n" + "box,1,Mill,Store A\n".repeat(tasks);
  }
}
