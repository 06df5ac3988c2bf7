package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer.OrderAnnotation;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ApiClient;
import org.toqa.testbed.FuzzRun;
import org.toqa.testbed.Needed;
import org.toqa.testbed.Tally;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;

/**
 * Schemathesis, a fuzzer made for OpenAPI documents, against a running server: it finds no answer
 * that is a fault, and none that the document does not have.
 *
 * <p>{@code -Dtoqa.schemathesis} is the program; {@code -Dtoqa.fuzz.examples=100} for more than the
 * usual 3 a route beside those that the document itself suggests, {@code -Dtoqa.seed=2} for other
 * ones. What the document suggests is tried by a manager; {@code -Dtoqa.attacks=whole} by
 * everybody. Leaves out the live events, which do not end.
 */
@Tag("full")
@TestMethodOrder(OrderAnnotation.class)
class ApiFuzzIT {
  private static final String PROGRAM = System.getProperty("toqa.schemathesis", "");
  private static final int EXAMPLES = Integer.getInteger("toqa.fuzz.examples", 3);
  private static final String CLERK = "clerk";
  private static final String CLERKS_PASSWORD = "clerk-of-robots";
  private static final Duration LIMIT = Duration.ofMinutes(30);

  private static final List<String> PHASES =
      "whole".equals(System.getProperty("toqa.attacks"))
          ? List.of()
          : List.of("--phases", "fuzzing");

  private static final String ENDS_SESSIONS = "/session$|/sessions/|/users/.id.$";

  @TempDir private static Path folder;
  private static RunningServer server;

  @BeforeAll
  static void start() throws Exception {
    Needed.orLeftOut(!PROGRAM.isEmpty(), "Schemathesis: ./toqa test fetches it");
    Path config = Files.writeString(folder.resolve("server.yaml"), "requestsPerSecond: 0\n");
    server = new RunningServer(folder, "--config", config.toString(), "--simulate", "3");
    for (int task = 0; task < 3; task++) {
      server.addTask("box", "Workbench 2", "Mill");
    }
    Map<String, String> clerk = Map.of("name", CLERK, "password", CLERKS_PASSWORD, "role", "CLERK");
    server.api().post("users", clerk);
  }

  @AfterAll
  static void stop() {
    if (server != null) {
      server.close();
    }
  }

  @Test
  @Order(1)
  void anonymousClientFindsNoFault() throws Exception {
    assertFindsNothing(PHASES);
  }

  @Test
  @Order(2)
  void aClerkFindsNoFault() throws Exception {
    try (ApiClient clerk = new ApiClient(server.root(), CLERK, CLERKS_PASSWORD)) {
      assertFindsNothing(PHASES, "-H", bearer(clerk), "--exclude-path-regex", ENDS_SESSIONS);
    }
  }

  @Test
  @Order(3)
  void aManagerFindsNoFault() throws Exception {
    assertFindsNothing(
        List.of(), "-H", bearer(server.api()), "--exclude-path-regex", ENDS_SESSIONS);
  }

  @Test
  @Order(4)
  void aManagerWhoseSessionEndsFindsNoFault() throws Exception {
    assertFindsNothing(
        List.of(), "-H", bearer(server.api()), "--include-path-regex", ENDS_SESSIONS);
  }

  @Test
  @Order(5)
  void theServerNeverSpokeOfAFault() throws Exception {
    assertEquals("UP", server.api().get("health").get("status").asString());
    server.kill();
    assertEquals(
        List.of(), server.errorOutput().stream().filter(line -> line.contains(" ERROR ")).toList());
  }

  private static String bearer(ApiClient user) {
    return "Authorization: Bearer " + user.token();
  }

  private static void assertFindsNothing(List<String> phases, String... choice) throws Exception {
    Path settings =
        Path.of("src/test/resources/org/toqa/endtoend/schemathesis.toml").toAbsolutePath();
    List<String> command = new ArrayList<>(List.of(PROGRAM, "--config-file", settings.toString()));
    command.addAll(List.of("run", copyOfTheDocument(), "--url", server.root().toString()));
    command.addAll(List.of("--seed", "" + FuzzRun.SEED, "-n", "" + EXAMPLES));
    command.addAll(phases);
    command.addAll(List.of(choice));
    try (ToqaProcess fuzzer = ToqaProcess.command(folder, command.toArray(String[]::new))) {
      int exitCode = fuzzer.exitCode(LIMIT);
      String report = String.join("\n", fuzzer.out());

      assertEquals(0, exitCode, report);
      assertTrue(number("Selected: (\\d+)", report) == number("Tested: (\\d+)", report), report);
      long generated = number("(\\d+) generated", report);
      assertTrue(generated > EXAMPLES && generated >= number("Tested: (\\d+)", report), report);
      Tally.add("requests by Schemathesis", generated);
    }
  }

  private static long number(String pattern, String report) {
    Matcher matcher = Pattern.compile(pattern).matcher(report);
    assertTrue(matcher.find(), report);
    return Long.parseLong(matcher.group(1));
  }

  private static String copyOfTheDocument() throws Exception {
    JsonNode document = server.api().get("openapi.json");
    return Files.writeString(folder.resolve("openapi.json"), document.toString()).toString();
  }
}
