package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class DemoIT {
  /** The simulated microcontroller is a few times faster than the real one, on a quick machine. */
  private static final Duration FIRMWARE_LIMIT = Duration.ofMinutes(8);

  @TempDir private Path folder;

  @ParameterizedTest
  @ValueSource(ints = {3, 6})
  void theDemoTasksAreDoneAndReported(int robots) throws Exception {
    Path report = folder.resolve("report.json");
    Path bodies = folder.resolve("bodies.jsonl");
    try (ToqaProcess demo =
        ToqaProcess.toqa(
            folder,
            "demo",
            "--once",
            "--bodies",
            bodies.toString(),
            "--robots",
            String.valueOf(robots),
            "--speed",
            "20",
            "--port",
            "0",
            "--report",
            report.toString())) {
      assertEquals(0, demo.exitCode(), () -> "it said: " + report);
    }
    RecordedBodies.read(bodies).assertClear(robots);
    JsonNode tasks = JsonMapper.builder().build().readTree(Files.readString(report)).get("tasks");
    assertTrue(tasks.size() > robots);
    for (JsonNode task : tasks) {
      assertEquals("DONE", task.get("state").asString(), task.toString());
      int carriers = task.get("name").asString().equals("Gearbox to packing") ? 3 : 1;
      assertEquals(carriers, task.get("robots").size(), task.toString());
      assertTrue(task.get("seconds").asDouble() > 0, task.toString());
    }
  }

  @Test
  @Tag("full")
  void theRealFirmwareDrivesOneOfTheRobots() throws Exception {
    Path report = folder.resolve("report.json");
    try (ToqaProcess demo =
        ToqaProcess.toqa(
            folder,
            "demo",
            "--once",
            "--firmware",
            "--robots",
            "1",
            "--speed",
            "4",
            "--port",
            "0",
            "--report",
            report.toString())) {
      assertEquals(0, demo.exitCode(FIRMWARE_LIMIT));
    }
    JsonNode tasks = JsonMapper.builder().build().readTree(Files.readString(report)).get("tasks");
    assertFalse(tasks.isEmpty());
    for (JsonNode task : tasks) {
      assertEquals("DONE", task.get("state").asString(), task.toString());
      assertEquals("r1", task.get("robots").get(0).asString(), task.toString());
    }
  }

  @Test
  void endingItLeavesNothing() throws Exception {
    try (ToqaProcess demo = ToqaProcess.toqa(folder, "demo", "--port", "0")) {
      demo.awaitErr("Log in as demo");
      demo.terminate();
      // 128 + SIGTERM; a suite in the background hands on that Ctrl-C is ignored
      assertEquals(143, demo.exitCode());
    }
  }
}
