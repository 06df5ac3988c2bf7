package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ToqaProcess;

/** The packaged jar alone: whatever the daemon needs and is not in it would show here. */
class AgentJarIT {
  @TempDir private Path folder;

  @Test
  void aRobotWithTheSampleConfigurationGreetsItsServer() throws Exception {
    Path config = folder.resolve("agent.yaml");
    String sample = Files.readString(Path.of("raspberry-agent/agent.yaml"));
    Files.writeString(config, sample.replaceFirst("(?m)^port: .*$", "port: 0"));

    try (ToqaProcess agent =
        ToqaProcess.jar(folder, Path.of("target/toqa-agent.jar"), "--config", config.toString())) {
      int port = Integer.parseInt(agent.awaitErr("port (\\d+)").group(1));
      String hello = firstLine(port);
      assertTrue(hello.contains("\"type\":\"hello\""), hello);
      assertTrue(hello.contains("\"robot\":\"r1\""), hello);

      agent.awaitErr("r1: self-test passed: battery 100 %, 3 range sensors, knows where it is");
      agent.terminate();

      // 128 + SIGTERM: the end of a process that was told to end
      assertEquals(143, agent.exitCode());
      assertTrue(
          agent.err().stream().noneMatch(line -> line.contains("Exception")),
          agent.err().toString());
    }
  }

  private static String firstLine(int port) throws Exception {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      socket.setSoTimeout(10_000);
      BufferedReader lines =
          new BufferedReader(
              new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
      return String.valueOf(lines.readLine());
    }
  }
}
