package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
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

  /** Straight on, nowhere, and round a corner. */
  private static final String WAYS_SCEN =
      """
      version 1
      0	small.map	5	3	0	0	4	0	4
      0	small.map	5	3	0	0	0	0	0
      0	small.map	5	3	2	0	4	2	4
      """;

  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @BeforeEach
  void writeFiles() throws IOException {
    Files.writeString(file("small.map"), MAP);
    Files.writeString(file("small.scen"), SCEN);
    Files.writeString(file("ways.scen"), WAYS_SCEN);
  }

  @Test
  void mapfPrintsWhatItFoundAndWritesThePlan() throws IOException {
    assertEquals(0, run("mapf " + MAPF + " --robots 3 --limit-ms 200 --plan plan"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertTrue(json.path("solved").booleanValue());
    assertEquals(12, json.path("lowerBound").intValue()); // 4 + 6 + 2
    assertTrue(json.path("sumOfCosts").intValue() >= 12);
    assertTrue(json.path("firstMs").isNumber());
    assertEquals(200, json.path("limitMs").intValue());
    assertTrue(json.path("leavesOut").size() > 0, json::toString);
    List<String> plan = Files.readAllLines(file("plan"));
    assertEquals("0,0 4,0 0,2", plan.getFirst());
    assertEquals("4,0 0,2 0,0", plan.getLast());
  }

  /** No plan is as short as if each robot were alone: it is improved until the limit. */
  @Test
  void mapfSaysWhenItTrulyEnded() throws IOException {
    Files.writeString(file("small.map"), MAP.replace(".@.@.", "@@.@@"));
    Files.writeString(
        file("small.scen"),
        """
        version 1
        0	small.map	5	3	0	0	4	0	4
        0	small.map	5	3	4	0	0	0	4
        """);

    long begin = System.nanoTime();
    assertEquals(0, run("mapf " + MAPF + " --robots 2 --repeat 1 --limit-ms 300"));
    double took = (System.nanoTime() - begin) / 1e6;

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertTrue(
        json.path("sumOfCosts").intValue() > json.path("lowerBound").intValue(), json::toString);
    double elapsed = json.path("elapsedMs").doubleValue();
    assertTrue(elapsed >= 300 && elapsed <= took, () -> json + " of " + took + " ms");
  }

  @ParameterizedTest
  @CsvSource({"soak --hours 0.1", "tasks"})
  void aWrongDatabaseIsNamedByTheOption(String bench) {
    assertEquals(2, run(bench + " --database nowhere"));
    assertTrue(err.toString().contains("--database "), err::toString);
    assertFalse(err.toString().contains("database.url"), err::toString);
  }

  @Test
  void everyBenchSaysWhatItLeavesOut() {
    Set<String> benches = new CommandLine(new BenchCommand()).getSubcommands().keySet();
    assertEquals(LeftOut.values().length, benches.size());
    for (String bench : benches) {
      assertFalse(LeftOut.of(bench).sentences().isEmpty(), bench);
    }
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
  @CsvSource({"octile", "heading"})
  void scenChecksTheLengthsAndWritesThem(String moves) throws IOException {
    assertEquals(0, run("scen " + WAYS + " --lengths lengths --moves " + moves));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertEquals(3, json.path("queries").intValue());
    assertEquals(3, json.path("solved").intValue());
    assertEquals(0, json.path("mismatches").intValue());
    assertTrue(json.path("nodesPerSecond").doubleValue() > 0);
    assertTrue(json.path("p50Micros").doubleValue() > 0);
    assertTrue(json.path("p99Micros").doubleValue() >= json.path("p50Micros").doubleValue());
    assertTrue(json.path("maxMicros").doubleValue() >= json.path("meanMicros").doubleValue());
    boolean turns = moves.equals("heading"); // the last one's corner costs as much as a cell
    assertEquals(turns ? 1 : 0, json.path("turnsOnSpot").intValue());
    assertEquals(List.of("4.0", "0.0", turns ? "5.0" : "4.0"), Files.readAllLines(file("lengths")));
  }

  @Test
  void scenNamesEachMismatch() throws IOException {
    Files.writeString(
        file("small.map"), MAP.replace(".@.@.\n.....", ".@.@.\n@@@@@")); // the last one has no way
    Files.writeString(file("ways.scen"), WAYS_SCEN.replace("0\t4\n", "0\t3.9\n"));

    assertEquals(1, run("scen " + WAYS + " --lengths lengths"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertEquals(2, json.path("solved").intValue());
    assertEquals(2, json.path("mismatches").intValue());
    assertTrue(err.toString().contains("query 1: The length is 4.0; the file has 3.9."));
    assertTrue(err.toString().contains("query 3: No path was found"), err::toString);
    assertEquals(List.of("4.0", "0.0", "-1"), Files.readAllLines(file("lengths")));
  }

  @Test
  void aHeadingWayMayBeLongerThanTheFileSaysButNotShorter() throws IOException {
    Files.writeString(file("ways.scen"), WAYS_SCEN.replace("0\t4\n", "0\t3.9\n"));
    assertEquals(0, run("scen " + WAYS + " --moves heading"));

    Files.writeString(file("ways.scen"), WAYS_SCEN.replace("0\t4\n", "0\t4.1\n"));
    assertEquals(1, run("scen " + WAYS + " --moves heading"));
    assertTrue(err.toString().contains("query 1: The length is 4.0; the file has 4.1."));
  }

  @Test
  void scenStopsAtTheLimit() throws IOException {
    assertEquals(0, run("scen " + WAYS + " --limit 2 --lengths lengths"));

    assertEquals(2, JsonMapper.shared().readTree(out.toString()).path("queries").intValue());
    assertEquals(List.of("4.0", "0.0"), Files.readAllLines(file("lengths")));
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

  @ParameterizedTest
  @CsvSource({"classic", "turns"})
  void withoutRingsNoneGoesRoundAtOnce(String model) throws IOException {
    Files.writeString(file("small.map"), "type octile\nheight 2\nwidth 3\nmap\n...\n...\n");
    String command = "traffic --map small.map --robots 5 --steps 200 --seed 5 --model " + model;

    run(command + " --trace with");
    run(command + " --trace without --no-rings");

    assertTrue(rings(Files.readAllLines(file("with"))) > 0);
    assertEquals(0, rings(Files.readAllLines(file("without"))));
  }

  /** In how many steps some robots go each to the cell that the next of them leaves. */
  private static long rings(List<String> trace) {
    return IntStream.range(1, trace.size())
        .filter(
            step -> {
              String[] from = cells(trace.get(step - 1));
              String[] to = cells(trace.get(step));
              Map<String, String> moves = new HashMap<>();
              for (int robot = 0; robot < from.length; robot++) {
                if (!from[robot].equals(to[robot])) {
                  moves.put(from[robot], to[robot]);
                }
              }
              return moves.keySet().stream().anyMatch(start -> leadsBack(moves, start));
            })
        .count();
  }

  private static boolean leadsBack(Map<String, String> moves, String start) {
    String at = moves.get(start);
    for (int steps = 0; steps < moves.size() && at != null && !at.equals(start); steps++) {
      at = moves.get(at);
    }
    return start.equals(at);
  }

  private static String[] cells(String line) {
    return line.replaceAll(",[NESW]", "").split(" ");
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
          traffic --map small.map --robots 2 --steps 9 --no-rings --planner reservation | --no-rings is for --planner rolling
          traffic --map small.map --robots 2 --steps 9 --trace none/trace | none/trace must be a file in a folder
          traffic --map small.map --steps 9 --tasks bad.tasks   | line 2: expected a start and its goals
          scen --map small.map --scen none.scen                 | none.scen
          scen --map small.map --scen small.map                 | expected 'version 1'
          scen --map small.map --scen other.scen                | is for a map of 6 x 3 cells
          scen --map small.map --scen small.scen --limit 0      | --limit 0: it must be from 1
          scen --map small.map --scen small.scen --moves fly    | it is octile or heading, not fly
          scen --map small.map --scen small.scen --lengths none/l | none/l must be a file in a folder
          scen --map small.map                                  | --scen
          mapf --map small.map --scen small.scen --robots 14 --limit-ms 9 | --robots 14: it must be from 1 to 13
          mapf --map small.map --scen small.map --robots 1 --limit-ms 9 | expected 'version 1'
          mapf --map small.map --scen small.scen --robots 1     | --limit-ms
          fleet --robots 2 --least-pace -1                      | --least-pace -1.0: it must be from 0 to 100
          fleet --robots 2 --least-pace nan                     | --least-pace
          """)
  void aWrongArgumentIsOneSentenceAndExitTwo(String command, String words) throws IOException {
    Files.writeString(file("bad.tasks"), "0,0 4,0\n1,1 0,0\n");
    Files.writeString(file("other.scen"), SCEN.replace("5\t3", "6\t3"));

    assertEquals(2, run(command));

    assertEquals("", out.toString());
    assertTrue(err.toString().contains(words), err::toString);
  }

  private static final String MAPF = "--map small.map --scen small.scen";
  private static final String WAYS = "--map small.map --scen ways.scen";

  private Path file(String name) {
    return folder.resolve(name);
  }

  /** Words after an option for a file are files in the test's folder. */
  private int run(String command) {
    String[] words = command.split(" +");
    for (int i = 1; i < words.length; i++) {
      boolean isFile =
          List.of("--map", "--scen", "--plan", "--trace", "--tasks", "--lengths")
              .contains(words[i - 1]);
      words[i] = isFile ? file(words[i]).toString() : words[i];
    }
    return new CommandLine(new BenchCommand())
        .setOut(new PrintWriter(out, true))
        .setErr(new PrintWriter(err, true))
        .execute(Stream.of(words).toArray(String[]::new));
  }
}
