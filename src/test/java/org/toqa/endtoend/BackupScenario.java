package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.toqa.testbed.ApiClient;
import tools.jackson.databind.JsonNode;

/**
 * What a server with one robot has to keep in a backup: users, schedules, tasks and what they did.
 */
final class BackupScenario {
  private static final String CLERK = "clerk";
  private static final String CLERKS_PASSWORD = "clerk-of-robots";

  private final RunningServer server;
  private final long done;
  private final long carried;
  private final long queued;

  private BackupScenario(RunningServer server, long done, long carried, long queued) {
    this.server = server;
    this.done = done;
    this.carried = carried;
    this.queued = queued;
  }

  /** One task is done, one is being carried, and one waits. */
  static BackupScenario start(RunningServer server) throws Exception {
    server.api().post("users", Map.of("name", CLERK, "password", CLERKS_PASSWORD, "role", "CLERK"));
    server
        .api()
        .post(
            "schedules",
            Map.of(
                "task",
                RunningServer.order("tour", "Mill", "Store A"),
                "at",
                "2098-07-01T15:00:00Z"));
    long done = server.addTask("done", "Packing 1", "Goods-out");
    server.awaitState(done, "DONE");
    long carried = server.addTask("carried", "Goods-out", "Packing 1");
    long queued = server.addTask("queued", "Packing 1", "Goods-out");
    server.awaitState(carried, "CARRYING");
    return new BackupScenario(server, done, carried, queued);
  }

  /** What the backup does not know. */
  void workAfterBackup() throws Exception {
    long unknown = server.addTask("not in the backup", "Packing 1", "Goods-out");
    assertTrue(unknown > queued);
    server.awaitState(carried, "DONE");
  }

  void assertRestoredAndContinues() throws Exception {
    ApiClient api = server.api();
    assertEquals(3, api.count("tasks"));
    assertEquals("DONE", server.state(done));
    assertEquals(1, server.eventCount(done, "Delivered"));
    assertTrue(api.get("history?task=" + done).toString().contains("Picked up"));
    JsonNode schedule = api.get("schedules").get(0);
    assertEquals("tour", schedule.get("task").get("name").asString());
    try (ApiClient clerk = new ApiClient(server.root(), CLERK, CLERKS_PASSWORD)) {
      assertEquals(1, clerk.get("users").size());
    }

    server.awaitState(carried, "DONE");
    server.awaitState(queued, "DONE");
    assertEquals(1, server.eventCount(queued, "Delivered"));
  }
}
