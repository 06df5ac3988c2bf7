package org.toqa.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code ./toqa}, as a user types it. */
@Tag("full")
class ToqaScriptIT {
  @TempDir private Path folder;

  @Test
  void helpListsEveryCommand() throws Exception {
    try (ToqaProcess help = ToqaProcess.toqa(folder, "--help")) {
      assertEquals(0, help.exitCode());
      for (String command : Main.commandLine().getSubcommands().keySet()) {
        assertTrue(
            help.out().stream().anyMatch(line -> line.startsWith("  " + command + " ")), command);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"demo", "server", "agent", "gateway", "http-robot", "plan", "bench", "test"})
  void everyCommandExplainsItself(String command) throws Exception {
    try (ToqaProcess help = ToqaProcess.toqa(folder, command, "--help")) {
      assertEquals(0, help.exitCode(), () -> "it said " + said(help));
      assertTrue(help.out().getFirst().startsWith("Usage: "), help.out().toString());
    }
  }

  /** Of the script, of each program, and what a program reads first; all else: CommandLineTest. */
  static Stream<Arguments> wrongArguments() {
    return Stream.of(
        Arguments.of(List.of(), "a command is missing"),
        Arguments.of(List.of("fly"), "there is no command \"fly\""),
        Arguments.of(List.of("server", "--prot", "80"), "the nearest is --port"),
        Arguments.of(List.of("server", "--port", "http"), "a whole number from 0 to 65535"),
        Arguments.of(List.of("server", "--config", "nowhere.yaml"), "there is no such file"),
        Arguments.of(List.of("demo", "--speed", "0"), "from 0.1 to 100"),
        Arguments.of(List.of("agent", "--confg", "x"), "--config"),
        Arguments.of(List.of("test", "me"), "\"me\" is not known"));
  }

  @ParameterizedTest
  @MethodSource("wrongArguments")
  void aWrongArgumentGetsOneLineAndExitCodeTwo(List<String> arguments, String expected)
      throws Exception {
    try (ToqaProcess toqa = ToqaProcess.toqa(folder, arguments.toArray(String[]::new))) {
      assertEquals(2, toqa.exitCode(), () -> "it said " + said(toqa));
      assertEquals(List.of(), toqa.out());
      assertEquals(1, toqa.err().size(), toqa.err().toString());
      assertTrue(toqa.err().getFirst().contains(expected), toqa.err().toString());
    }
  }

  @Test
  void theLogIsReadByPrograms() throws Exception {
    Map<String, String> variables = Map.of("TOQA_LOG_FORMAT", "json", "TOQA_SIMULATE", "1");
    String data = folder.resolve("data").toString();
    try (ToqaProcess server =
        ToqaProcess.toqa(folder, variables, "server", "--port", "0", "--data", data)) {
      server.awaitErr("http://[^ ]*");
      server.terminate();
      List<JsonNode> lines =
          server.err().stream()
              .filter(line -> !line.startsWith("Toqa is at "))
              .map(new JsonMapper()::readTree)
              .toList();

      assertFalse(lines.isEmpty());
      for (JsonNode line : lines) {
        assertFalse(line.get("formattedMessage").asString().isBlank(), line::toString);
        assertTrue(line.get("timestamp").asLong() > 0, line::toString);
        assertFalse(line.get("level").asString().isBlank(), line::toString);
      }
    }
  }

  @Test
  void theServerEndsWhenItIsTold() throws Exception {
    try (ToqaProcess server = ToqaProcess.toqa(folder, "server", "--port", "0")) {
      URI address = URI.create(server.awaitErr("http://[^ ]*").group());
      assertEquals(200, status(address.resolve("first-start")));
      server.awaitErr("the first page asks for the code [A-Z0-9]{4}-[A-Z0-9]{4}-[A-Z0-9]{4}");

      server.terminate();

      // 128 + SIGTERM: the end of a process that was told to end
      assertEquals(143, server.exitCode());
      assertTrue(server.err().stream().noneMatch(line -> line.contains("Exception")), said(server));
    }
  }

  @Test
  void aSecondServerOnThePortIsRefusedInOneLine() throws Exception {
    try (ToqaProcess first = ToqaProcess.toqa(folder, "server", "--port", "0")) {
      String port = first.awaitErr("http://[^ ]*:(\\d+)/").group(1);
      try (ToqaProcess second =
          ToqaProcess.toqa(folder, "server", "--port", port, "--data", "other")) {
        assertEquals(1, second.exitCode());
        assertEquals(1, second.err().size(), said(second));
        assertTrue(second.err().getFirst().startsWith("toqa: Port " + port), said(second));
      }
    }
  }

  @Test
  void aLinkToTheScriptWorksAsTheScript() throws Exception {
    Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("toqa").toAbsolutePath());
    try (ToqaProcess help = ToqaProcess.command(folder, link.toString(), "server", "--help")) {
      assertEquals(0, help.exitCode(), () -> "it said " + said(help));
    } finally {
      Files.delete(link);
    }
  }

  private static int status(URI uri) throws Exception {
    try (HttpClient client = HttpClient.newHttpClient()) {
      return client
          .send(HttpRequest.newBuilder(uri).build(), HttpResponse.BodyHandlers.discarding())
          .statusCode();
    }
  }

  private static String said(ToqaProcess process) {
    try {
      return process.err().toString();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "";
    }
  }
}
