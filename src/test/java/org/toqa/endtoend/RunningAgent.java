package org.toqa.endtoend;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.testbed.ToqaProcess;

/** A robot's daemon in a process of its own, over a simulated body, killed and started again. */
final class RunningAgent implements AutoCloseable {
  private final String name;
  private final Path home;
  private final int port = freePort();
  private final List<ToqaProcess> killed = new ArrayList<>();
  private @Nullable ToqaProcess process;

  /**
   * @param folder in which the robot's own one is made
   * @param x metres, where a new robot is, map frame
   * @param speed how many times faster than real time it lives
   */
  RunningAgent(Path folder, String name, double x, double y, double speed) throws Exception {
    this.name = name;
    this.home = Files.createDirectories(folder.resolve(name));
    Files.writeString(
        home.resolve("agent.yaml"),
        """
        name: %s
        port: %d
        dataDir: data
        chassis:
          type: simulated
          start: {x: %s, y: %s, heading: 0}
          speed: %s
        """
            .formatted(name, port, x, y, speed));
    start();
  }

  /** Ends it and starts it so that it shows a code; what it shows. */
  String restartForPairing() throws IOException, InterruptedException {
    kill();
    start("--pair");
    return Objects.requireNonNull(process).awaitErr("Pairing code: (\\S+)").group(1);
  }

  String name() {
    return name;
  }

  int port() {
    return port;
  }

  void start(String... options) throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(List.of("agent", "--config", home.resolve("agent.yaml").toString()));
    command.addAll(List.of(options));
    process = ToqaProcess.toqa(home, Map.of(), command.toArray(String[]::new));
    process.awaitErr(name + ".*" + port);
  }

  /** As {@code kill -9} does it. */
  void kill() throws InterruptedException {
    ToqaProcess running = Objects.requireNonNull(process);
    running.kill();
    killed.add(running);
  }

  /** Everything on standard error of the daemons that were killed. */
  List<String> errorOutput() throws InterruptedException {
    List<String> lines = new ArrayList<>();
    for (ToqaProcess daemon : killed) {
      lines.addAll(daemon.err());
    }
    return lines;
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  @Override
  public void close() {
    Objects.requireNonNull(process).close();
  }
}
