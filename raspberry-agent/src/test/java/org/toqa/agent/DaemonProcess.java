package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** A daemon as a process of its own. */
final class DaemonProcess implements AutoCloseable {

  private final Process process;
  private final BufferedReader output;
  private final int port;

  /** Starts it; it listens when this returns. */
  DaemonProcess(Path config) throws IOException {
    process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx64m",
                "-cp",
                System.getProperty("java.class.path"),
                "org.toqa.agent.Main",
                "--config",
                config.toString())
            .redirectErrorStream(true)
            .start();
    output = process.inputReader(StandardCharsets.UTF_8);
    String line = output.readLine();
    while (line != null && !line.contains("listening on")) {
      line = output.readLine();
    }
    assertNotNull(line, "the daemon ended");
    port = Integer.parseInt(line.replaceAll(".* port (\\d+)\\.", "$1"));
  }

  Process process() {
    return process;
  }

  /** What it says after it listens. */
  BufferedReader output() {
    return output;
  }

  int port() {
    return port;
  }

  /** Kills it without a warning. */
  @Override
  public void close() {
    process.destroyForcibly();
  }
}
