package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

@Tag("full")
class SmoothBenchTest {
  private static final String MAP = "type octile\nheight 3\nwidth 5\nmap\n.....\n..@..\n..@..\n";

  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String arguments) throws IOException {
    Path map = Files.writeString(folder.resolve("wall.map"), MAP);
    return new CommandLine(new BenchCommand())
        .setOut(new PrintWriter(out, true))
        .setErr(new PrintWriter(err, true))
        .execute(
            Stream.of(("smooth " + arguments.replace("MAP", map.toString())).split(" "))
                .toArray(String[]::new));
  }

  @Test
  void aRunTellsThePathAndTheExactLength() throws IOException {
    assertEquals(
        0, run("--map MAP --from 0.5,0.5 --to 4.5,0.5 --radius 0.3 --limit-ms 20 --repeat 2"));
    JsonNode runs = JsonMapper.shared().readTree(out.toString()).path("runs");
    assertEquals(2, runs.size());
    for (JsonNode run : runs) {
      assertTrue(run.path("found").booleanValue());
      assertTrue(run.path("reason").isNull());
      // the exact length is that of the shortest path, so no curve is shorter
      assertTrue(run.path("ratio").doubleValue() >= 1 - 1e-6);
      assertTrue(run.path("maxCurvature").doubleValue() > 0);
      assertEquals(0.5, run.path("path").path(0).path(0).doubleValue(), 1e-9);
    }
  }

  @Test
  void whereThereIsNoneTheReasonIsTold() throws IOException {
    assertEquals(1, run("--map MAP --from 0.5,0.5 --to 4.5,0.5 --radius 0.501 --limit-ms 5"));
    assertEquals(
        "START_BLOCKED",
        JsonMapper.shared()
            .readTree(out.toString())
            .path("runs")
            .path(0)
            .path("reason")
            .stringValue());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --map MAP                                                   | are needed
          --map MAP --from 1,1 --to 1,1 --limit-ms 0                  | --limit-ms 0: it must be
          --map MAP --from 1,1 --to 1,1 --limit-ms 9 --repeat 0       | --repeat 0: it must be
          --map MAP --from 1,1 --to 1,1 --limit-ms 9 --radius 0       | --radius 0.0: it must be
          --map MAP --from 1,1 --to 1,1 --limit-ms 9 --radius NaN     | --radius NaN: it must be
          --map MAP --from 1 --to 1,1 --limit-ms 9                    | expected X,Y
          --map nowhere.map --from 1,1 --to 1,1 --limit-ms 9          | nowhere.map
          --map MAP --from 1,1 --to 1,1 --limit-ms 9 --scenes 3       | --scenes is for random scenes
          --from 1,1                                                  | need --map
          --radius 0.3                                                | at most 0.2
          --method magic                                              | it is rrt-star, particle-swarm or hybrid
          """)
  void badInputIsRefusedInASentence(String arguments, String words) throws IOException {
    assertEquals(2, run(arguments));
    assertTrue(err.toString().contains(words), err::toString);
    assertEquals("", out.toString());
  }
}
