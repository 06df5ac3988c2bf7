package org.toqa.app.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** A robot's daemon as a process of its own, with its unit's options and a simulated body. */
final class MeasuredDaemon implements AutoCloseable {
  static final List<String> OPTIONS =
      List.of("-Xmx64m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1");

  private static final Pattern LISTENING = Pattern.compile("listening on .*?(\\d+)\\.?$");

  private final Process process;
  private final int port;
  private final double startMillis;

  private MeasuredDaemon(Process process, int port, double startMillis) {
    this.process = process;
    this.port = port;
    this.startMillis = startMillis;
  }

  /**
   * Returns when it listens.
   *
   * @param folder for its configuration and data
   * @throws IOException it cannot be started, or ends before it listens
   */
  static MeasuredDaemon start(Path jar, Path folder) throws IOException {
    Path config =
        Files.writeString(
            folder.resolve("agent.yaml"),
            """
            name: r1
            port: 0
            dataDir: data
            chassis: {type: simulated, start: {x: 2, y: 1}}
            """);
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    List<String> command =
        Stream.of(
                List.of(java),
                OPTIONS,
                List.of("-jar", jar.toString(), "--config", config.toString()))
            .flatMap(List::stream)
            .toList();
    long began = System.nanoTime();
    Process process =
        new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
    BufferedReader output = process.inputReader(StandardCharsets.UTF_8);
    for (String line = output.readLine(); line != null; line = output.readLine()) {
      Matcher listening = LISTENING.matcher(line);
      if (listening.find()) {
        double millis = (System.nanoTime() - began) / 1e6;
        Thread.ofVirtual().name("daemon output").start(() -> output.lines().forEach(word -> {}));
        return new MeasuredDaemon(process, Integer.parseInt(listening.group(1)), millis);
      }
    }
    throw new IOException("The daemon ended before it listened.");
  }

  /** The TCP port on which it listens. */
  int port() {
    return port;
  }

  /** From its start until it listened, milliseconds. */
  double startMillis() {
    return startMillis;
  }

  /** Processor time that it has used since it started; zero where the system does not tell. */
  Duration processorTime() {
    return process.info().totalCpuDuration().orElse(Duration.ZERO);
  }

  /**
   * Its resident memory, in units of 2^20 bytes; empty where the system does not tell.
   *
   * @throws IOException the system's answer cannot be read
   */
  Optional<Double> megabytes() throws IOException {
    Path status = Path.of("/proc", String.valueOf(process.pid()), "status");
    if (!Files.isReadable(status)) {
      return Optional.empty();
    }
    try (Stream<String> lines = Files.lines(status)) {
      return lines
          .filter(line -> line.startsWith("VmRSS:"))
          .map(line -> Double.parseDouble(line.replaceAll("\\D", "")) / 1024)
          .findFirst();
    }
  }

  /** Returns when it is gone, so that its folder can go too. */
  @Override
  public void close() {
    process.destroyForcibly().onExit().join();
  }
}
