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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class AllocationBenchTest {
  private static final String MAP =
      """
      type octile
      height 5
      width 12
      map
      ............
      ............
      ..@@@..@@@..
      ............
      ............
      """;

  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @BeforeEach
  void writeMap() throws IOException {
    Files.writeString(folder.resolve("small.map"), MAP);
  }

  @Test
  void everyPolicyDeliversEveryTask() {
    JsonNode policies = measured("--robots", "3", "--tasks", "40").path("policies");

    for (String name : List.of("nearest", "zones", "contract-net", "optimal")) {
      JsonNode report = policies.path(name);
      assertEquals(40, report.path("delivered").intValue(), name);
      assertTrue(report.path("meanSeconds").doubleValue() > 0, name);
      assertTrue(
          report.path("worstSeconds").doubleValue() >= report.path("meanSeconds").doubleValue(),
          name);
      // 88.8 J a metre without a load
      assertTrue(
          report.path("joules").doubleValue() >= 88.8 * report.path("metres").doubleValue(), name);
    }
  }

  @Test
  void negotiationsGoOnWithoutThoseThatAreSilentOrLate() {
    JsonNode report =
        measured(
                "--robots",
                "4",
                "--tasks",
                "20",
                "--policy",
                "contract-net",
                "--exchange",
                "--silent",
                "1",
                "--slow-bidders",
                "1",
                "--bidder-delay",
                "300")
            .path("policies")
            .path("contract-net");

    assertEquals(20, report.path("delivered").intValue());
    JsonNode negotiations = report.path("negotiations");
    assertTrue(negotiations.path("bids").intValue() > 0);
    assertTrue(negotiations.path("silent").intValue() > 0);
    assertEquals(20, negotiations.path("awards").intValue());
    assertTrue(negotiations.path("meanMs").doubleValue() >= 300, negotiations::toString);
  }

  @Test
  void theSameSeedIsTheSameWork() {
    String[] arguments = {"--robots", "2", "--tasks", "20", "--policy", "optimal", "--seed", "7"};

    assertEquals(metres(measured(arguments)), metres(measured(arguments)));
  }

  @Test
  void tasksMayBeExchangedUntilTheirLoadsArePickedUp() {
    JsonNode policies =
        measured("--robots", "4", "--tasks", "40", "--pressure", "120", "--exchange")
            .path("policies");

    policies.forEach(report -> assertEquals(40, report.path("delivered").intValue()));
    assertEquals(4, policies.size());
  }

  @Test
  void theSolverIsTimedWhereThatIsAskedFor() {
    JsonNode json =
        measured("--robots", "1", "--tasks", "1", "--policy", "zones", "--solver-size", "20");

    assertTrue(json.path("solverMs").isNumber());
  }

  @Test
  void wrongArgumentsAreRefused() {
    assertEquals(CommandLine.ExitCode.USAGE, run("--robots", "0"));
    assertEquals(CommandLine.ExitCode.USAGE, run("--policy", "best"));
    assertEquals(CommandLine.ExitCode.USAGE, run("--robots", "900")); // more than there are cells
    assertTrue(
        err.toString().contains("--robots 900: the map has too few free cells for that"),
        err.toString());
  }

  private static double metres(JsonNode json) {
    return json.path("policies").path("optimal").path("metres").doubleValue();
  }

  private JsonNode measured(String... arguments) {
    out.getBuffer().setLength(0);
    assertEquals(CommandLine.ExitCode.OK, run(arguments), err.toString());
    return JsonMapper.shared().readTree(out.toString());
  }

  private int run(String... arguments) {
    return new CommandLine(new AllocationBench(() -> folder.resolve("small.map")))
        .setOut(new PrintWriter(out, true))
        .setErr(new PrintWriter(err, true))
        .execute(arguments);
  }
}
