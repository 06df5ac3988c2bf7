package org.toqa.agent.routing;

import java.io.File;
import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.toqa.link.trust.PrivateFile;

/**
 * The files and the process of the babeld of one daemon. It outlives a daemon that is killed, and
 * goes on forwarding; the next daemon takes it over. For one thread.
 */
final class BabeldProcess {

  private static final Duration LONGEST_END = Duration.ofSeconds(2);
  private static final long LARGEST_LOG = 1_000_000;

  /** What a Unix socket's name has at most, bytes. */
  private static final int LONGEST_SOCKET = 107;

  /** Of packets while a link is down, and of radios that tell no channel. */
  private static final List<String> EVERYDAY = List.of("send:", "Warning:");

  /** The routes that babeld gives the kernel, in the main table (protocol 42). */
  private static final List<String> FLUSH = List.of("-4", "route", "flush", "proto", "42");

  private final Path program;
  private final Path ip;
  private final Path folder;
  private final String configuration;

  /**
   * @param program babeld
   * @param ip the program of that name
   * @param folder where its files are
   * @throws IOException with a sentence for people: its socket would have too long a name
   */
  BabeldProcess(Path program, Path ip, Path folder, String configuration) throws IOException {
    this.program = program;
    this.ip = ip;
    this.folder = folder.toAbsolutePath();
    this.configuration = configuration;
    if (socket().toString().getBytes(StandardCharsets.UTF_8).length > LONGEST_SOCKET) {
      throw new IOException(
          "The name of the socket %s is too long for this system: choose a dataDir with a shorter one."
              .formatted(socket()));
    }
  }

  /** Of its local interface. */
  Path socket() {
    return folder.resolve("babeld.socket");
  }

  private Path configurationFile() {
    return folder.resolve("babeld.conf");
  }

  private Path processFile() {
    return folder.resolve("babeld.pid");
  }

  private Path log() {
    return folder.resolve("babeld.log");
  }

  /** The one that an earlier daemon has left; empty: none runs, or it was configured otherwise. */
  Optional<ProcessHandle> takeOver() throws IOException, InterruptedException {
    Optional<ProcessHandle> left = left();
    if (left.isPresent() && !isConfiguredSo()) {
      end(left.get());
      return Optional.empty();
    }
    return left;
  }

  private boolean isConfiguredSo() throws IOException {
    return Files.exists(configurationFile())
        && Files.readString(configurationFile()).equals(configuration);
  }

  private Optional<ProcessHandle> left() throws IOException {
    if (!Files.exists(processFile())) {
      return Optional.empty();
    }
    try {
      return ProcessHandle.of(Long.parseLong(Files.readString(processFile()).strip()))
          .filter(process -> process.isAlive() && isOurs(process.pid()));
    } catch (NumberFormatException e) {
      return Optional.empty(); // it was killed while it wrote it
    }
  }

  /** Numbers of processes are used again. */
  private boolean isOurs(long pid) {
    try {
      String words =
          Files.readString(
              Path.of("/proc", String.valueOf(pid), "cmdline"), StandardCharsets.UTF_8);
      return List.of(words.split("\0", -1)).contains(configurationFile().toString());
    } catch (IOException e) {
      return false;
    }
  }

  /**
   * Starts one, where none runs: without the routes that one which was killed has left, for babeld
   * does not replace what it has not set itself.
   */
  ProcessHandle start() throws IOException, InterruptedException {
    flushRoutes();
    new PrivateFile(configurationFile()).write(configuration.getBytes(StandardCharsets.UTF_8));
    Files.deleteIfExists(processFile());
    Files.deleteIfExists(socket());
    Files.deleteIfExists(log());
    return new ProcessBuilder(
            program.toString(),
            "-c",
            configurationFile().toString(),
            "-g",
            socket().toString(),
            "-I",
            processFile().toString(),
            "-S",
            folder.resolve("babeld.state").toString())
        .redirectInput(new File("/dev/null"))
        .redirectErrorStream(true)
        .redirectOutput(Redirect.appendTo(log().toFile()))
        .start()
        .toHandle();
  }

  private void flushRoutes() throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(ip.toString()));
    command.addAll(FLUSH);
    Process flush =
        new ProcessBuilder(command)
            .redirectInput(new File("/dev/null"))
            .redirectErrorStream(true)
            .redirectOutput(Redirect.DISCARD)
            .start();
    if (!flush.waitFor(LONGEST_END.toMillis(), TimeUnit.MILLISECONDS)) {
      flush.destroyForcibly(); // one that fails has found no table of routes
    }
  }

  /** Lets it take its routes back and end; one that hangs is killed. */
  void end(ProcessHandle process) throws InterruptedException {
    process.destroy();
    try {
      process.onExit().get(LONGEST_END.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException | ExecutionException e) {
      process.destroyForcibly();
    }
  }

  /** What it said last beside its everyday complaints; empty: nothing. */
  Optional<String> lastWords() {
    try {
      return Arrays.stream(Files.readString(log(), StandardCharsets.ISO_8859_1).split("\n"))
          .map(String::strip)
          .filter(line -> !line.isEmpty() && EVERYDAY.stream().noneMatch(line::startsWith))
          .reduce((first, second) -> second);
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** Nobody reads more of it. */
  void limitLog() throws IOException {
    if (Files.exists(log()) && Files.size(log()) > LARGEST_LOG) {
      Files.write(log(), new byte[0]);
    }
  }
}
