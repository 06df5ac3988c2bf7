package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Instant;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/** A schedule through {@code kill -9} of its server. */
@Tag("full")
class ScheduleIT {
  @TempDir private Path folder;

  @Test
  void whatIsDueWhileNoServerRunsIsMadeUpForOnce() throws Exception {
    try (RunningServer server = new RunningServer(folder)) {
      Map<String, Object> tour = RunningServer.order("tour", "Mill", "Store A");
      Instant due = Instant.now().plusSeconds(2);
      server.api().post("schedules", Map.of("task", tour, "at", due.toString()));

      server.killAndRestart();

      JsonNode schedule = server.await("schedules/1", s -> !s.get("lastTask").isNull());
      assertTrue(schedule.get("due").isNull(), "it was due once");
      assertEquals("tour", server.task(schedule.get("lastTask").asLong()).get("name").asString());
      server.killAndRestart();
      assertEquals(1, server.api().count("tasks"));
    }
  }
}
