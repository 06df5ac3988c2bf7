package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.SteadyNetwork;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code ./toqa bench smoothness}, as a user types it. */
@Tag("full")
@ExtendWith(SteadyNetwork.class)
class SmoothnessBenchIT {
  private static final String[] COMMAND = {
    "bench", "smoothness", "--robots", "3", "--warm-up", "2", "--seconds", "4"
  };

  @TempDir private Path folder;

  @Test
  void framesAreMeasured() throws Exception {
    try (ToqaProcess bench = ToqaProcess.toqa(folder, COMMAND)) {
      assertEquals(0, bench.exitCode());
      JsonNode json = JsonMapper.shared().readTree(bench.out().getFirst());
      long frames = json.get("frames").get("count").asLong();
      double seconds = json.get("seconds").asDouble();
      assertEquals(frames / seconds, json.get("framesPerSecond").asDouble(), 1e-6);
      assertTrue(frames > 4, json::toString);
      // frames follow each other without a gap: all of them together are no longer than the time
      assertTrue(
          json.get("frames").get("p50Ms").asDouble() * frames / 2 <= seconds * 1000 + 1000,
          json::toString);
      assertTrue(
          json.get("frames").get("maxMs").asDouble() >= 1000 * seconds / (frames + 1) / 2,
          json::toString);
      assertTrue(json.get("drawing").get("count").asLong() > 4, json::toString);
    }
  }

  @Test
  void withoutChromiumItSaysWhatToInstall() throws Exception {
    String java = Path.of(System.getProperty("java.home")).toString();
    try (ToqaProcess bench =
        ToqaProcess.command(
            folder,
            "/usr/bin/env",
            "PATH=" + folder,
            java + "/bin/java",
            "-jar",
            Path.of("target/toqa.war").toAbsolutePath().toString(),
            "bench",
            "smoothness")) {
      assertEquals(2, bench.exitCode());
      List<String> said = bench.err();
      assertEquals(1, said.size(), said::toString);
      assertTrue(said.getFirst().contains(HeadlessChromium.MISSING), said::toString);
    }
  }
}
