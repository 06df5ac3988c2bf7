package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.SteadyNetwork;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code ./toqa bench web}. */
@Tag("full")
@ExtendWith(SteadyNetwork.class)
class WebBenchIT {
  @TempDir private Path folder;

  @Test
  void pagesAndTheWholeWayOfPosesAreMeasured() throws Exception {
    try (ToqaProcess bench =
        ToqaProcess.program(
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
      assertTrue(json.get("pages").get("count").asLong() > 0, json::toString);
      assertTrue(json.get("pages").get("p99Ms").asDouble() > 0, json::toString);
      assertTrue(json.get("poses").get("count").asLong() > 0, json::toString);
      assertTrue(json.get("poses").get("p50Ms").asDouble() > 0, json::toString);
      double heard = json.get("heard").get("p50Ms").asDouble();
      double seen = json.get("seen").get("p50Ms").asDouble();
      assertTrue(json.get("seen").get("count").asLong() > 0, json::toString);
      assertEquals(json.get("seen").get("count"), json.get("heard").get("count"));
      assertTrue(heard > 0 && heard <= seen, json::toString);
      // one in a hundred may be from the first word of a new connection
      assertTrue(
          json.get("unmatched").asLong() * 100 <= json.get("seen").get("count").asLong(),
          json::toString);
      if (HeadlessChromium.find().isPresent()) {
        double drawing = json.get("drawing").get("p50Ms").asDouble();
        double drawn = json.get("drawn").get("p50Ms").asDouble();
        assertTrue(json.get("drawn").get("count").asLong() > 0, json::toString);
        assertTrue(drawn >= Math.max(heard, drawing), json::toString);
      } else {
        assertTrue(json.get("drawn").isNull(), json::toString);
        assertTrue(bench.err().toString().contains(HeadlessChromium.MISSING), json::toString);
      }
      assertTrue(json.get("eventsSeen").asLong() > 0, json::toString);
      assertEquals(0, json.get("failed").asInt());
    }
  }
}
