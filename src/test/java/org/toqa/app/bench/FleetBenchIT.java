package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code ./toqa bench fleet}, as a user types it. */
class FleetBenchIT {
  @TempDir private Path folder;

  @Test
  void aFleetIsMeasured() throws Exception {
    try (ToqaProcess bench =
        ToqaProcess.toqa(
            folder, "bench", "fleet", "--robots", "3", "--warm-up", "5", "--seconds", "5")) {
      assertEquals(0, bench.exitCode());
      JsonNode json = JsonMapper.shared().readTree(bench.out().getFirst());
      assertEquals(3, json.get("robots").asInt());
      assertTrue(json.get("seconds").asDouble() >= 5, json::toString);
      assertTrue(json.get("pace").asDouble() > 0, json::toString);
      assertTrue(json.get("cores").asDouble() > 0, json::toString);
      assertTrue(json.get("metresDriven").asDouble() > 0, json::toString);
      assertTrue(json.get("nearestMetres").asDouble() >= 0, json::toString);
    }
  }
}
