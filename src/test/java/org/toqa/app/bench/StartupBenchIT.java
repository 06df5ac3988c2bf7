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

/** {@code ./toqa bench startup}, as a user types it. */
@Tag("full")
class StartupBenchIT {
  @TempDir private Path folder;

  @Test
  void startsAreMeasured() throws Exception {
    long begun = System.nanoTime();
    try (ToqaProcess bench = ToqaProcess.toqa(folder, "bench", "startup", "--runs", "1")) {
      assertEquals(0, bench.exitCode(), () -> "it failed");
      double tookMs = (System.nanoTime() - begun) / 1e6;
      JsonNode json = JsonMapper.shared().readTree(bench.out().getFirst());
      double first = json.get("first").get("maxMs").asDouble();
      double again = json.get("again").get("maxMs").asDouble();
      // no JVM with a database and a web server is up in so short a time
      assertTrue(first > 500 && again > 500, json::toString);
      assertTrue(first + again < tookMs, json + " of " + tookMs + " ms");
      assertEquals(1, json.get("first").get("count").asInt());
    }
  }
}
