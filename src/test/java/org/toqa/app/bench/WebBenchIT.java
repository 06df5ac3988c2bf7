package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code ./toqa bench web}, as a user types it. */
class WebBenchIT {
  @TempDir private Path folder;

  @Test
  void pagesAndPosesAreMeasured() throws Exception {
    try (ToqaProcess bench =
        ToqaProcess.toqa(
            folder,
            "bench",
            "web",
            "--robots",
            "3",
            "--browsers",
            "5",
            "--rate",
            "10",
            "--warm-up",
            "3",
            "--seconds",
            "5")) {
      assertEquals(0, bench.exitCode());
      JsonNode json = JsonMapper.shared().readTree(bench.out().getFirst());
      assertTrue(json.get("pages").get("count").asLong() > 10, json::toString);
      assertTrue(json.get("pages").get("p99Ms").asDouble() > 0, json::toString);
      assertTrue(json.get("poses").get("count").asLong() > 10, json::toString);
      assertTrue(json.get("poses").get("p50Ms").asDouble() > 0, json::toString);
      assertTrue(json.get("eventsSeen").asLong() > 10, json::toString);
      assertEquals(0, json.get("failed").asInt());
    }
  }
}
