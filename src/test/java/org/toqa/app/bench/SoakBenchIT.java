package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code ./toqa bench soak}. */
@Tag("full")
class SoakBenchIT {
  @TempDir private Path folder;

  @Test
  void minutesOfWorkAreMeasured() throws Exception {
    try (ToqaProcess bench =
        ToqaProcess.program(folder, "bench", "soak", "--hours", "0.05", "--robots", "3")) {
      assertEquals(0, bench.exitCode());
      JsonNode json = JsonMapper.shared().readTree(bench.out().getFirst());
      assertEquals(0.05, json.get("hours").asDouble(), 0.01, json::toString);
      assertTrue(json.get("tasksDone").asInt() > 0, json::toString);
      assertTrue(
          json.get("longestWaitSeconds").asDouble() >= json.get("waitP50Seconds").asDouble(),
          json::toString);
      JsonNode last = json.get("samples").get(json.get("samples").size() - 1);
      assertEquals(json.get("tasksDone").asInt(), last.get("tasksDone").asInt());
      assertTrue(last.get("contentMb").asDouble() > 0, json::toString);
      assertTrue(
          last.get("databaseMb").asDouble() >= last.get("contentMb").asDouble(), json::toString);
      assertEquals(0, json.get("stuck").size(), json::toString);
      assertTrue(json.get("leavesOut").size() > 0, json::toString);
    }
  }
}
