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

/** {@code ./toqa bench fleet}. */
@Tag("full")
class FleetBenchIT {
  @TempDir private Path folder;

  @Test
  void aFleetIsMeasured() throws Exception {
    try (ToqaProcess bench =
        ToqaProcess.program(
            folder, "bench", "fleet", "--robots", "3", "--warm-up", "5", "--seconds", "5")) {
      assertEquals(0, bench.exitCode());
      JsonNode json = JsonMapper.shared().readTree(bench.out().getFirst());
      assertEquals(3, json.get("robots").asInt());
      assertTrue(json.get("seconds").asDouble() >= 5, json::toString);
      assertTrue(json.get("pace").asDouble() > 0, json::toString);
      assertTrue(json.get("cores").asDouble() > 0, json::toString);
      assertTrue(json.get("metresDriven").asDouble() > 0, json::toString);
      assertTrue(json.get("nearestMetres").isNumber(), json::toString);
      assertTrue(json.get("trueNearestMetres").asDouble() > 0, json::toString);
      assertTrue(json.get("trueWallMetres").asDouble() > 0, json::toString);
      // looked at 50 times a second of the simulated time
      double simulated = json.get("seconds").asDouble() * json.get("pace").asDouble();
      assertEquals(50 * simulated, json.get("trueSamples").asDouble(), 10, json::toString);
      assertTrue(json.get("leavesOut").size() > 0, json::toString);
    }
  }

  @Test
  void paceThatIsTooSlowFails() throws Exception {
    try (ToqaProcess bench =
        ToqaProcess.program(
            folder,
            "bench",
            "fleet",
            "--robots",
            "2",
            "--warm-up",
            "0",
            "--seconds",
            "1",
            "--least-pace",
            "90")) {
      assertEquals(1, bench.exitCode());
      String said = bench.err().toString();
      assertTrue(said.contains("is below 90"), said);
    }
  }
}
