package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class BenchCommandTest {
  private static final String MAP =
      """
      type octile
      height 3
      width 5
      map
      .....
      .@.@.
      .....
      """;

  /** Three robots, each to the place of the next. */
  private static final String SCEN =
      """
      version 1
      0	small.map	5	3	0	0	4	0	4
      0	small.map	5	3	4	0	0	2	6
      0	small.map	5	3	0	2	0	0	2
      """;

  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @BeforeEach
  void writeFiles() throws IOException {
    Files.writeString(file("small.map"), MAP);
    Files.writeString(file("small.scen"), SCEN);
  }

  @Test
  void mapfPrintsWhatItFoundAndWritesThePlan() throws IOException {
    assertEquals(0, run("mapf " + MAPF + " --robots 3 --limit-ms 200 --plan plan"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertTrue(json.path("solved").booleanValue());
    assertEquals(12, json.path("lowerBound").intValue()); // 4 + 6 + 2
    assertTrue(json.path("sumOfCosts").intValue() >= 12);
    assertTrue(json.path("firstMs").isNumber());
    List<String> plan = Files.readAllLines(file("plan"));
    assertEquals("0,0 4,0 0,2", plan.getFirst());
    assertEquals("4,0 0,2 0,0", plan.getLast());
  }

  @Test
  void robotsThatTheScenarioLacksStandAndGoAnywhere() throws IOException {
    assertEquals(0, run("mapf " + MAPF + " --robots 6 --limit-ms 200 --plan plan"));

    List<String> plan = Files.readAllLines(file("plan"));
    assertTrue(plan.getFirst().matches("0,0 4,0 0,2 \\d,\\d \\d,\\d \\d,\\d"), plan::getFirst);
    assertTrue(err.toString().contains("3 more stand and go anywhere"), err::toString);
  }

  @Test
  void mapfSaysWhyItFails() throws IOException {
    Files.writeString(
        file("small.map"), MAP.replaceAll("@.@", "@@@").replace(".....\n", "...@.\n"));

    assertEquals(1, run("mapf " + MAPF + " --robots 3 --limit-ms 200"));

    assertEquals(false, JsonMapper.shared().readTree(out.toString()).path("solved").booleanValue());
    assertTrue(err.toString().contains("NO_WAY (line 1, cell (4,0))"), err::toString);
  }

  @ParameterizedTest
  @CsvSource({"classic,rolling", "turns,rolling", "classic,reservation", "turns,reservation"})
  void trafficPrintsWhatWasReachedAndTracesEveryStep(String model, String planner)
      throws IOException {
    assertEquals(
        0,
        run(
            "traffic --map small.map --robots 3 --steps 40 --seed 5 --trace trace --model "
                + model
                + " --planner "
                + planner));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertEquals(0, json.path("collisions").intValue());
    assertTrue(json.path("goals").intValue() > 0);
    assertTrue(json.path("stuck").isNumber());
    assertTrue(json.path("p50Ms").isNumber());
    assertTrue(json.path("p99Ms").isNumber());
    List<String> trace = Files.readAllLines(file("trace"));
    assertEquals(41, trace.size());
    String robot = model.equals("turns") ? "\\d,\\d,[NESW]" : "\\d,\\d";
    assertTrue(
        trace.stream().allMatch(line -> line.matches(robot + " " + robot + " " + robot)),
        trace::toString);
  }

  @Test
  void theSameSeedDrivesTheSameWay() throws IOException {
    String command = "traffic --map small.map --robots 3 --steps 40 --limit-ms 60000 --seed 5";
    run(command + " --trace one");
    run(command + " --trace other");

    assertEquals(Files.readString(file("one")), Files.readString(file("other")));
  }

  @Test
  void listedTasksAreDrivenInOrderAndThenItEnds() throws IOException {
    Files.writeString(file("tasks"), "# two robots\n0,0,S 4,2 4,0\n\n2,0 2,2 # to the south\n");

    assertEquals(
        0, run("traffic --map small.map --steps 200 --model turns --tasks tasks --trace trace"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertEquals(3, json.path("goals").intValue());
    List<String> trace = Files.readAllLines(file("trace"));
    assertEquals("0,0,S 2,0,E", trace.getFirst());
    assertTrue(trace.getLast().matches("4,0,. 2,2,."), trace::getLast);
    assertEquals(trace.size() - 1, json.path("steps").intValue());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          traffic --map none.map --robots 2 --steps 9           | none.map
          traffic --map small.map --robots 13 --steps 9         | --robots 13: it must be from 1 to 12
          traffic --map small.map --robots 0 --steps 9          | --robots 0: it must be from 1 to 12
          traffic --map small.map --robots x --steps 9          | 'x'
          traffic --map small.map --robots 2 --steps 0          | --steps 0: it must be from 1
          traffic --map small.map --steps 9                     | --robots is missing
          traffic --map small.map --robots 2 --steps 9 --model flying | --model flying: it is classic or turns
          traffic --map small.map --robots 2 --steps 9 --trace none/trace | none/trace must be a file in a folder
          traffic --map small.map --steps 9 --tasks bad.tasks   | line 2: expected a start and its goals
          mapf --map small.map --scen small.scen --robots 14 --limit-ms 9 | --robots 14: it must be from 1 to 13
          mapf --map small.map --scen small.map --robots 1 --limit-ms 9 | expected 'version 1'
          mapf --map small.map --scen small.scen --robots 1     | --limit-ms
          """)
  void aWrongArgumentIsOneSentenceAndExitTwo(String command, String words) throws IOException {
    Files.writeString(file("bad.tasks"), "0,0 4,0\n1,1 0,0\n");

    assertEquals(2, run(command));

    assertEquals("", out.toString());
    assertTrue(err.toString().contains(words), err::toString);
  }

  private static final String MAPF = "--map small.map --scen small.scen";

  private Path file(String name) {
    return folder.resolve(name);
  }

  /** Words with a dot or after --plan, --trace and --tasks are files in the test's folder. */
  private int run(String command) {
    String[] words = command.split(" +");
    for (int i = 1; i < words.length; i++) {
      boolean isFile =
          List.of("--map", "--scen", "--plan", "--trace", "--tasks").contains(words[i - 1]);
      words[i] = isFile ? file(words[i]).toString() : words[i];
    }
    return new CommandLine(new BenchCommand())
        .setOut(new PrintWriter(out, true))
        .setErr(new PrintWriter(err, true))
        .execute(Stream.of(words).toArray(String[]::new));
  }
}
