package org.toqa.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** What the server's commands say of themselves, and to arguments that they cannot take. */
class CommandLineTest {
  static Stream<Arguments> wrongArguments() {
    return Stream.of(
        Arguments.of(List.of("server", "--port"), "'--port'"),
        Arguments.of(List.of("server", "now"), "\"now\" is not known"),
        Arguments.of(List.of("demo", "--robots", "9"), "--robots \"9\": it must be"),
        Arguments.of(List.of("demo", "--robots", "six"), "\"six\" is not a whole number"),
        Arguments.of(List.of("demo", "--report", "no/such/folder"), "that can be written"),
        Arguments.of(List.of("demo", "--bodies", "no/such/folder"), "that can be written"),
        Arguments.of(
            List.of("demo", "--scenario", "store", "--firmware"), "does not go with --firmware"),
        Arguments.of(
            List.of("demo", "--scenario", "yard", "--firmware"), "does not go with --firmware"),
        Arguments.of(
            List.of("demo", "--scenario", "building", "--speed", "2"), "it goes with neither"),
        Arguments.of(List.of("plan", "--map", "nowhere.yaml"), "--from"),
        Arguments.of(List.of("plan", "--bogus"), "\"--bogus\" is not known"),
        Arguments.of(List.of("plan", "--nope"), "\"--nope\" is not known (toqa plan --help"),
        Arguments.of(List.of("gateway"), "--config"),
        Arguments.of(List.of("gateway", "--config", "nowhere.yaml"), "there is no such file"),
        Arguments.of(List.of("http-robot", "--token", "short"), "16 to 128 letters"),
        Arguments.of(List.of("http-robot", "--slip", "2"), "--slip 2.0: it must be from 0"),
        Arguments.of(List.of("http-robot", "--tls"), "--tls needs --data"),
        Arguments.of(List.of("bench", "http", "--robots", "3,0"), "--robots 0: it must be"),
        Arguments.of(List.of("bench", "swim"), "\"swim\" is not known"),
        Arguments.of(
            List.of("bench", "fleet", "--robots", "1"), "--robots 1: it must be from 2 to 500"));
  }

  static Stream<CommandLine> commands() {
    return withSubcommands(Main.commandLine());
  }

  private static Stream<CommandLine> withSubcommands(CommandLine command) {
    return Stream.concat(
        Stream.of(command),
        command.getSubcommands().values().stream().flatMap(CommandLineTest::withSubcommands));
  }

  /** Picocli tells what it cannot format to the standard error, and prints it unformatted. */
  @ParameterizedTest
  @MethodSource("commands")
  void aHelpIsPrintedWithoutComplaint(CommandLine command) {
    PrintStream standardError = System.err;
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    System.setErr(new PrintStream(said, true, StandardCharsets.UTF_8));
    try {
      assertFalse(command.getUsageMessage().contains("%n"), command.getUsageMessage());
    } finally {
      System.setErr(standardError);
    }
    assertEquals("", said.toString(StandardCharsets.UTF_8), command.getCommandName());
  }

  /** Its own lines; picocli would break longer ones in their midst. */
  @ParameterizedTest
  @MethodSource("commands")
  void theLinesOfAHelpFitATerminal(CommandLine command) {
    for (String line : command.getCommandSpec().usageMessage().footer()) {
      assertTrue(line.replace("%%", "%").length() < 80, line);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"server", "bench"})
  void aCommandAloneSaysWhatItSaysAmongAll(String name) {
    CommandLine alone = Main.commandLineFor(name, "--help").getSubcommands().get(name);
    CommandLine amongAll = Main.commandLine().getSubcommands().get(name);

    assertEquals(amongAll.getUsageMessage(), alone.getUsageMessage());
    assertEquals(Set.of(name), Main.commandLineFor(name).getSubcommands().keySet());
    assertEquals(
        Main.commandLine().getSubcommands().keySet(),
        Main.commandLineFor("--help").getSubcommands().keySet());
  }

  @ParameterizedTest
  @MethodSource("wrongArguments")
  void aWrongArgumentGetsOneLineAndExitCodeTwo(List<String> arguments, String expected) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();

    int exitCode =
        Main.commandLineFor(arguments.toArray(String[]::new))
            .setOut(new PrintWriter(out, true))
            .setErr(new PrintWriter(err, true))
            .execute(arguments.toArray(String[]::new));

    assertEquals(2, exitCode, err::toString);
    assertEquals("", out.toString());
    assertEquals(1, err.toString().lines().count(), err::toString);
    assertTrue(err.toString().contains(expected), err::toString);
  }
}
