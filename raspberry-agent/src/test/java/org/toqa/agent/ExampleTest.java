package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.config.AgentConfig;
import picocli.CommandLine;

/** The configuration that {@code --example} prints. */
class ExampleTest {
  @TempDir
  @SuppressWarnings("NullAway.Init") // set by JUnit
  Path folder;

  @Test
  void theExampleIsAConfigurationThatWorks() throws Exception {
    StringWriter printed = new StringWriter();

    int code = new CommandLine(new Main()).setOut(new PrintWriter(printed)).execute("--example");

    assertEquals(0, code);
    assertEquals(Files.readString(Path.of("raspberry-agent/agent.yaml")), printed.toString());
    Path file = folder.resolve("r1.yaml");
    Files.writeString(file, printed.toString());
    assertEquals("r1", AgentConfig.read(file).name());
  }

  @Test
  void withoutAConfigurationItIsSaidWhatIsMissing() {
    StringWriter said = new StringWriter();

    int code = new CommandLine(new Main()).setErr(new PrintWriter(said)).execute();

    assertEquals(2, code);
    assertEquals(
        "Missing required option: '--config=FILE', or '--example'",
        said.toString().lines().findFirst().orElse(""));
  }
}
