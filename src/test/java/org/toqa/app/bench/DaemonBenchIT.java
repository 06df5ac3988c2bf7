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

/** {@code ./toqa bench daemon}, as a user types it. */
@Tag("full")
class DaemonBenchIT {
  @TempDir private Path folder;

  @Test
  void aDaemonIsMeasuredStandingAndLeading() throws Exception {
    try (ToqaProcess bench =
        ToqaProcess.toqa(folder, "bench", "daemon", "--seconds", "3", "--busy", "1")) {
      assertEquals(0, bench.exitCode());
      JsonNode json = JsonMapper.shared().readTree(bench.out().getFirst());
      assertTrue(json.get("startMs").asDouble() > 0, json::toString);
      assertTrue(json.get("megabytes").asDouble() > 1, json::toString);
      assertTrue(json.get("standingCore").asDouble() > 0, json::toString);
      assertTrue(json.get("drivingCore").asDouble() > 0, json::toString);
      assertTrue(json.get("offBeat").get("count").asLong() > 3, json::toString);
      JsonNode offBeat = json.get("offBeat");
      assertTrue(
          offBeat.get("p50Ms").asDouble() <= offBeat.get("maxMs").asDouble(), json::toString);
    }
  }

  @Test
  void aWrongNumberIsRefusedWithASentence() throws Exception {
    try (ToqaProcess bench = ToqaProcess.toqa(folder, "bench", "daemon", "--busy", "many")) {
      assertEquals(2, bench.exitCode());
      assertTrue(bench.err().getFirst().contains("--busy"), bench.err().getFirst());
    }
  }
}
