package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

@Tag("full")
class FloorBenchTest {
  /** Robots meet in its aisles, and have to let each other pass. */
  private static final String MAP =
      """
      type octile
      height 4
      width 6
      map
      ......
      .@@.@.
      .@@.@.
      ......
      """;

  /** What depends on the machine, and on what else it does. */
  private static final List<String> TIMES =
      List.of(
          "planP50Ms",
          "planP99Ms",
          "planMaxMs",
          "tickP50Ms",
          "tickP99Ms",
          "tickMaxMs",
          "speed",
          "processorSeconds",
          "agentSeconds",
          "planSeconds",
          "robotSeconds");

  @TempDir private Path folder;
  private final StringWriter err = new StringWriter();

  @BeforeEach
  void writeMap() throws IOException {
    Files.writeString(folder.resolve("small.map"), MAP);
  }

  @Test
  void robotsDriveToGoalAfterGoalAndTouchNothing() {
    ObjectNode json = report("--robots 3 --seconds 120 --seed 5");

    // 3 robots at 0.25 m/s for 120 s are 90 m; a goal is 4 cells away, some time goes for turns
    assertTrue(json.path("goals").intValue() >= 6, json::toString);
    assertTrue(json.path("metres").doubleValue() > 25, json::toString);
    assertTrue(json.path("metres").doubleValue() < 90, json::toString);
    assertEquals(0, json.path("contacts").intValue());
    assertEquals(0, json.path("wallContacts").intValue());
    assertTrue(json.path("nearestMetres").doubleValue() > 0, json::toString);
    // a cell of 1 m at 0.25 m/s
    assertEquals(4, json.path("stepSeconds").doubleValue());
    assertEquals(
        json.path("goals").intValue() / 120.0, json.path("goalsPerSecond").doubleValue(), 1e-9);
    assertEquals(
        json.path("goals").intValue() / 30.0, json.path("goalsPerStep").doubleValue(), 1e-9);
    assertTrue(json.path("longestWaitSeconds").doubleValue() < 60, json::toString);
    assertTrue(json.path("plans").intValue() > 0, json::toString);
    assertTrue(
        json.path("planP99Ms").doubleValue() >= json.path("planP50Ms").doubleValue(),
        json::toString);
    TIMES.forEach(name -> assertTrue(json.path(name).doubleValue() > 0, name));
    assertTrue(json.path("leavesOut").size() > 0, json::toString);
  }

  /** One robot has two goals, one has three, and one has none. */
  @Test
  void robotsWithListsDriveToTheirGoalsAndStay() throws IOException {
    Path tasks = folder.resolve("tasks.txt");
    Files.writeString(tasks, "0,0,E 5,0 0,0\n0,3,E 3,3 2,3 4,3\n5,3,N\n");

    ObjectNode json = report("--seconds 120 --pose-error 0 --tasks " + tasks);

    assertEquals(5, json.path("goals").intValue(), json::toString);
    // 5 m and 5 m back; 3 m, 1 m back and 2 m
    assertEquals(16, json.path("metres").doubleValue(), 0.5, json::toString);
  }

  @Test
  void theSameSeedDrivesTheSameWay() {
    ObjectNode one = report("--robots 5 --seconds 60 --seed 5");
    ObjectNode again = report("--robots 5 --seconds 60 --seed 5");
    ObjectNode other = report("--robots 5 --seconds 60 --seed 6");

    assertEquals(one.remove(TIMES), again.remove(TIMES));
    assertTrue(!one.path("metres").equals(other.path("metres")), one::toString);
  }

  @Test
  void robotsThatAreWrongAboutTheirPlacesTouchAndTheRunFails() {
    ObjectNode json = report(1, "--robots 16 --seconds 20 --pose-error 1");

    assertTrue(json.path("contacts").intValue() > 0, json::toString);
    assertTrue(json.path("wallContacts").intValue() > 0, json::toString);
    assertTrue(json.path("nearestMetres").doubleValue() <= 0, json::toString);
    assertTrue(
        err.toString()
            .contains("two robots touched " + json.path("contacts").intValue() + " times"),
        err::toString);
    assertTrue(err.toString().contains("a robot touched a wall "), err::toString);
  }

  @Test
  void robotsFitCellsThatAreSmallerThanThem() throws IOException {
    Files.writeString(folder.resolve("fine.yaml"), "image: fine.pgm\nresolution: 0.2\n" + YAML);
    Files.writeString(folder.resolve("fine.pgm"), "P2 8 6 255\n" + "254 ".repeat(48));

    ObjectNode json = report(0, "--robots 2 --seconds 20 --pose-error 0", "fine.yaml");

    assertEquals(0.17, json.path("diameter").doubleValue(), 1e-9); // 85 % of a cell
    assertEquals(0.8, json.path("stepSeconds").doubleValue(), 1e-9); // 0.2 m at 0.25 m/s
    assertTrue(json.path("goals").intValue() > 2, json::toString);
  }

  private static final String YAML =
      "origin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          none.map  | --robots 2 --seconds 9                   | none.map
          small.map | --robots 18 --seconds 9                  | --robots 18: it must be from 1 to 17
          small.map | --robots 0 --seconds 9                   | --robots 0: it must be from 1 to 17
          small.map | --robots 2 --seconds 0                   | --seconds 0: it must be from 1
          small.map | --robots 2                               | --seconds
          small.map | --seconds 9                              | --robots
          small.map | --seconds 9 --tasks none.txt             | none.txt
          small.map | --robots 2 --seconds 9 --pose-error -0.1 | --pose-error -0.1: it must be from 0 to 1
          small.map | --robots 2 --seconds 9 --pose-error nan  | --pose-error
          small.map | --robots 2 --seconds 9 --store-ms 1001   | --store-ms 1001: it must be from 0 to 1000
          small.map | --robots 2 --seconds 9 --link-ms -1      | --link-ms -1: it must be from 0 to 1000
          small.map | --robots 2 --seconds 9 --look-nanos -1   | --look-nanos -1: it must be from 0
          small.map | --robots 2 --seconds 9 --warm-up 3601    | --warm-up 3601: it must be from 0 to 3600
          """)
  void aWrongArgumentIsOneSentenceAndExitTwo(String map, String options, String words) {
    StringWriter out = new StringWriter();

    assertEquals(2, run(out, map, options));

    assertEquals("", out.toString());
    assertTrue(err.toString().contains(words), err::toString);
  }

  private ObjectNode report(String options) {
    return report(0, options);
  }

  private ObjectNode report(int exit, String options) {
    return report(exit, options, "small.map");
  }

  private ObjectNode report(int exit, String options, String map) {
    StringWriter out = new StringWriter();
    assertEquals(
        exit, run(out, map, options + " --warm-up 0 --look-nanos 1000"), () -> out + "" + err);
    JsonNode json = JsonMapper.shared().readTree(out.toString());
    return (ObjectNode) json;
  }

  private int run(StringWriter out, String map, String options) {
    return new CommandLine(new BenchCommand())
        .setOut(new PrintWriter(out, true))
        .setErr(new PrintWriter(err, true))
        .execute(("floor --map " + folder.resolve(map) + " " + options).split(" +"));
  }
}
