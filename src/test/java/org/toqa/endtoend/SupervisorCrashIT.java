package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/**
 * A supervisor that lives in the server's process, and a worker whose daemon is a process of its
 * own, are killed in the middle of their work: every box is carried once, and a person is asked
 * where only he can know.
 */
@Tag("full")
class SupervisorCrashIT {
  private static final double SPEED = 25;

  /** Whether the server is killed at more moments. */
  private static final boolean IS_LONG = "whole".equals(System.getProperty("toqa.walk"));

  private static final String ARM =
      """
      arm:
        upperLink: 0.30
        foreLink: 0.25
        base: {x: 0.05, y: 0, heading: 0}
        maxLoad: 5
        shoulder: {least: -160, most: 160, maxRate: 90, maxAcceleration: 180}
        elbow: {least: -160, most: 160, maxRate: 90, maxAcceleration: 180}
        rest: {shoulder: 120, elbow: -150}
      """;

  /** Of at least 18 s: 28 m at 0.4 m/s, four times as fast as in truth. */
  private static final Map<String, Object> EXPLORATION =
      Map.of(
          "ground",
          "scene:store",
          "robots",
          1,
          "seed",
          7,
          "start",
          Map.of("x", 2, "y", 2),
          "target",
          Map.of("x", 28, "y", 18));

  private static final String SUPERVISION = "floors/yard/supervision";

  @TempDir private Path folder;
  private RunningServer server;
  private RunningAgent worker;

  @AfterEach
  void close() {
    worker.close();
    server.close();
  }

  /** The yard is 6 m x 3.3 m, and all of it is in view. */
  private void open() throws Exception {
    String row = "1 ".repeat(20).strip() + "\n";
    Files.writeString(folder.resolve("yard.pgm"), "P2\n20 11\n1\n" + row.repeat(11));
    Files.writeString(
        folder.resolve("yard.yaml"),
        """
        image: yard.pgm
        resolution: 0.30
        origin: [0.0, 0.0, 0.0]
        negate: 0
        occupied_thresh: 0.65
        free_thresh: 0.196
        """);
    Files.writeString(
        folder.resolve("yard.floor.yaml"),
        "parking:\n  - {name: P1, x: 5.55, y: 2.85}\n  - {name: P2, x: 0.45, y: 1.65}\n");
    Files.writeString(
        folder.resolve("boxes.yaml"),
        """
        floor: yard
        arms: []
        cameras: [r1]
        cameraRange: 9
        boxes:
          - {number: 1, x: 3.75, y: 2.1, weight: 1.5}
          - {number: 2, x: 4.5, y: 0.6, weight: 1.5}
        """);
    Files.writeString(
        folder.resolve("server.yaml"),
        "map: %s\nsimulateBoxes: %s\nlostAfter: 5\n"
            .formatted(folder.resolve("yard.yaml"), folder.resolve("boxes.yaml")));
    worker = new RunningAgent(folder, "carl", 0.45, 1.65, SPEED, "", ARM);
    server =
        new RunningServer(
            folder,
            "--config",
            folder.resolve("server.yaml").toString(),
            "--simulate",
            "1",
            "--speed",
            String.valueOf(SPEED));
    Map<String, Object> robot =
        Map.of(
            "name",
            "carl",
            "host",
            "127.0.0.1",
            "port",
            worker.port(),
            "maxLoad",
            5,
            "parking",
            "P2");
    server.api().post("robots", robot);
    server.await("robots", SupervisorCrashIT::areAllIdle);
  }

  private static boolean areAllIdle(JsonNode robots) {
    return robots.size() == 2
        && robots.valueStream().allMatch(robot -> robot.get("state").asString().equals("IDLE"));
  }

  private void begin() throws Exception {
    server.awaitAccepted(
        SUPERVISION,
        Map.of(
            "supervisor",
            "r1",
            "workers",
            List.of("carl"),
            "boxes",
            List.of(box(1, 1.5, 2.4), box(2, 1.5, 0.9))));
  }

  private static Map<String, Object> box(int number, double x, double y) {
    return Map.of("box", number, "target", Map.of("x", x, "y", y));
  }

  /** The box of which that is so, as soon as there is one. */
  private JsonNode awaitBox(Predicate<JsonNode> condition) throws Exception {
    return server
        .await(SUPERVISION, s -> s.get("boxes").valueStream().anyMatch(condition))
        .get("boxes")
        .valueStream()
        .filter(condition)
        .findFirst()
        .orElseThrow();
  }

  private static Predicate<JsonNode> in(String state) {
    return box -> box.get("state").asString().equals(state);
  }

  /** What it had stored is the draft, and the history says what has become of it. */
  private void assertExplorationIsCutOff() throws Exception {
    JsonNode ended = server.await("floors/yard/exploration", e -> !e.get("endedAt").isNull());
    assertEquals("INTERRUPTED", ended.get("state").asString());
    assertEquals("SAVED", ended.get("draft").asString());
    assertEquals(7, ended.get("seed").asLong());
    assertTrue(ended.get("area").asDouble() > 1, () -> "seen: " + ended.get("area"));
    assertFalse(server.api().get("floors/yard/draft").get("user").isNull());
    assertEquals(
        List.of("exploration.failed", "exploration.began"),
        server
            .api()
            .get("history?kind=exploration")
            .get("events")
            .valueStream()
            .map(entry -> entry.get("kind").asString())
            .toList());
  }

  @Test
  void everyBoxIsCarriedOnceWhoeverIsKilledAndWhoeverHasItInItsArmIsAskedAbout() throws Exception {
    open();
    begin();
    for (String state : IS_LONG ? List.of("FETCHED", "CARRIED") : List.<String>of()) {
      awaitBox(in(state));
      server.killAndRestart();
    }
    long task = awaitBox(in("CARRIED")).get("task").asLong();
    server.api().post("floors/yard/exploration", EXPLORATION);
    worker.kill();
    server.killAndRestart();
    assertExplorationIsCutOff();

    JsonNode asked = awaitBox(box -> !box.get("question").isNull());
    assertEquals(task, asked.get("task").asLong());
    assertTrue(asked.get("question").asString().contains("carl"), asked::toString);
    List<String> answers =
        Objects.requireNonNull(server.task(task).get("needs").get("answers"))
            .valueStream()
            .map(JsonNode::asString)
            .toList();
    assertTrue(answers.contains("wait"), answers::toString);
    server.awaitAccepted("tasks/" + task + "/answer", Map.of("answer", "wait"));
    worker.start();

    JsonNode done = server.await(SUPERVISION, s -> !s.get("state").asString().equals("RUNNING"));
    assertEquals("DONE", done.get("state").asString());
    assertFalse(done.get("idleSecondsPerBox").isNull());
    List<Long> tasks =
        done.get("boxes").valueStream().map(box -> box.get("task").asLong()).toList();
    for (long each : tasks) {
      server.awaitState(each, "DONE");
      assertEquals(1, server.eventCount(each, "Picked up"), () -> "picked up: " + done);
      assertEquals(1, server.eventCount(each, "Delivered"), () -> "delivered: " + done);
    }
    assertEquals(2, server.api().get("tasks").size(), "none was ordered twice");
  }
}
