package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.toqa.geometry.Vec2;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

@Execution(ExecutionMode.CONCURRENT)
class DemoIT {
  /** Whether the scenario of the store runs too: it takes a minute. */
  private static final boolean IS_WHOLE = "whole".equals(System.getProperty("toqa.walk"));

  @TempDir private Path folder;

  /** One that does its tasks and ends. */
  private ToqaProcess demo(String... options) throws IOException {
    List<String> all = new ArrayList<>(List.of("demo", "--once", "--port", "0"));
    all.addAll(List.of(options));
    return ToqaProcess.toqa(folder, all.toArray(String[]::new));
  }

  @Test
  void theDemoTasksAreDoneAndReported() throws Exception {
    Path report = folder.resolve("report.json");
    Path bodies = folder.resolve("bodies.jsonl");
    try (ToqaProcess demo =
        demo(
            "--bodies",
            bodies.toString(),
            "--robots",
            "3",
            "--speed",
            "20",
            "--report",
            report.toString())) {
      assertEquals(0, demo.exitCode(), () -> "it said: " + report);
      assertNoFailure(demo);
    }
    RecordedBodies.read(bodies).assertClear(3);
    JsonNode tasks = JsonMapper.builder().build().readTree(Files.readString(report)).get("tasks");
    assertTrue(tasks.size() > 3);
    assertDone(tasks);
    for (JsonNode task : tasks) {
      assertTrue(task.get("seconds").asDouble() > 0, task.toString());
    }
    if (IS_WHOLE) {
      assertTenBoxesAreBroughtToTheirTargets();
    }
  }

  /** Parts that fail are started again: the tasks alone do not show it. */
  private static void assertNoFailure(ToqaProcess demo) throws InterruptedException {
    List<String> failures = demo.err().stream().filter(line -> line.contains(" ERROR ")).toList();
    assertEquals(List.of(), failures);
  }

  /** A supervisor and two workers. */
  private void assertTenBoxesAreBroughtToTheirTargets() throws Exception {
    try (ToqaProcess demo = demo("--scenario", "store", "--speed", "40")) {
      assertEquals(0, demo.exitCode(), "it did not come to its end");
      assertNoFailure(demo);
      assertTrue(
          demo.err().stream().anyMatch(line -> line.contains("10 boxes of 10 at their targets")));
    }
  }

  /** All demo tasks, each by as many robots as its load needs. */
  static void assertDone(JsonNode tasks) {
    for (JsonNode task : tasks) {
      assertEquals("DONE", task.get("state").asString(), task.toString());
      int carriers = task.get("name").asString().equals("Gearbox to packing") ? 3 : 1;
      assertEquals(carriers, task.get("robots").size(), task.toString());
    }
  }

  @Test
  @Tag("full")
  void robotsFindTheirOwnWayAmongPeople() throws Exception {
    Path bodies = folder.resolve("bodies.jsonl");
    try (ToqaProcess demo =
        demo("--scenario", "yard", "--speed", "20", "--bodies", bodies.toString())) {
      assertEquals(0, demo.exitCode(), "not all tasks are done");
      assertNoFailure(demo);
    }
    double nearest = Double.POSITIVE_INFINITY;
    Set<String> crossed = new TreeSet<>();
    for (String line : Files.readAllLines(bodies)) {
      JsonNode robots = JsonMapper.shared().readTree(line).get("bodies");
      assertEquals(2, robots.size(), line);
      nearest = Math.min(nearest, middle(robots.get(0)).distanceTo(middle(robots.get(1))));
      for (JsonNode robot : robots) {
        if (Math.abs(middle(robot).x() - 5.4) < 0.1) { // in the middle of the zone
          crossed.add(robot.get("name").asString());
        }
      }
    }
    assertTrue(nearest > 2 * 0.1275, "they were " + nearest + " m apart");
    assertEquals(Set.of("r1", "r2"), crossed);
  }

  private static Vec2 middle(JsonNode robot) {
    JsonNode core = robot.get("core").get(0);
    return new Vec2(core.get("x").asDouble(), core.get("y").asDouble());
  }

  @Test
  @Tag("full")
  void theRealFirmwareDrivesOneOfTheRobots() throws Exception {
    Path report = folder.resolve("report.json");
    try (ToqaProcess demo =
        demo("--firmware", "--robots", "1", "--speed", "4", "--report", report.toString())) {
      assertEquals(0, demo.exitCode());
      assertNoFailure(demo);
    }
    JsonNode tasks = JsonMapper.builder().build().readTree(Files.readString(report)).get("tasks");
    assertFalse(tasks.isEmpty());
    for (JsonNode task : tasks) {
      assertEquals("DONE", task.get("state").asString(), task.toString());
      boolean isR1 = task.get("robots").get(0).asString().equals("r1");
      assertEquals(task.get("floor").asString().equals("lab"), isR1, task.toString());
    }
  }
}
