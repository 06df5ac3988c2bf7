package org.toqa.endtoend;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.testbed.ToqaProcess;

/** A robot's daemon in a process of its own, over a simulated body, killed and started again. */
final class RunningAgent implements AutoCloseable {
  private final String name;
  private final Path home;
  private final List<ToqaProcess> killed = new ArrayList<>();
  private final String config;
  private @Nullable ToqaProcess process;

  /** 0 until it has bound one, which it keeps when it is started again. */
  private int port;

  /**
   * @param folder in which the robot's own one is made
   * @param x metres, where a new robot is, map frame
   * @param speed how many times faster than real time it lives
   */
  RunningAgent(Path folder, String name, double x, double y, double speed) throws Exception {
    this(folder, name, x, y, speed, "");
  }

  /**
   * @param chassis more lines of YAML about its body
   */
  RunningAgent(Path folder, String name, double x, double y, double speed, String chassis)
      throws Exception {
    this(folder, name, x, y, speed, chassis, "");
  }

  /**
   * @param parts more lines of YAML about what it has beside its body
   */
  RunningAgent(
      Path folder, String name, double x, double y, double speed, String chassis, String parts)
      throws Exception {
    this.name = name;
    this.home = Files.createDirectories(folder.resolve(name));
    this.config =
        parts
            + """
        name: %s
        dataDir: data
        chassis:
          type: simulated
          start: {x: %s, y: %s, heading: 0}
          speed: %s
        """
                .formatted(name, x, y, speed)
            + chassis.indent(2);
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

  /** Where its daemon keeps what it must not forget, and its body. */
  Path data() {
    return home.resolve("data");
  }

  void freeze() throws IOException, InterruptedException {
    Objects.requireNonNull(process).freeze();
  }

  void thaw() throws IOException, InterruptedException {
    Objects.requireNonNull(process).thaw();
  }

  int port() {
    return port;
  }

  void start(String... options) throws IOException, InterruptedException {
    Files.writeString(home.resolve("agent.yaml"), config + "port: " + port + "\n");
    List<String> command =
        new ArrayList<>(List.of("--config", home.resolve("agent.yaml").toString()));
    command.addAll(List.of(options));
    process = ToqaProcess.agent(home, command.toArray(String[]::new));
    port = Integer.parseInt(process.awaitErr("listening on .* port (\\d+)").group(1));
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

  @Override
  public void close() {
    Objects.requireNonNull(process).close();
  }
}
