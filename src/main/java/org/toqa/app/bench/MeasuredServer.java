package org.toqa.app.bench;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** The complete server in a process of its own, asked whether it is healthy from its start on. */
final class MeasuredServer implements AutoCloseable {
  private static final Duration LIMIT = Duration.ofMinutes(5);
  private static final int POLL_MILLIS = 5;

  /** A connection that nobody takes up is not waited for. */
  private static final Duration TIMEOUT = Duration.ofSeconds(5);

  private final Process process;
  private final double startMillis;

  private MeasuredServer(Process process, double startMillis) {
    this.process = process;
    this.startMillis = startMillis;
  }

  /**
   * Returns when it is healthy.
   *
   * @param data its folder
   * @throws IOException it cannot be started, or ends before it is healthy
   */
  static MeasuredServer start(Path data) throws IOException, InterruptedException {
    int port = freePort();
    List<String> command =
        new ArrayList<>(List.of(java(), "--sun-misc-unsafe-memory-access=allow"));
    command.addAll(program());
    command.addAll(List.of("server", "--port", String.valueOf(port), "--data", data.toString()));
    ProcessBuilder builder =
        new ProcessBuilder(command)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.DISCARD);
    long begun = System.nanoTime();
    Process process = builder.start();
    try {
      URI health = URI.create("http://127.0.0.1:" + port + "/api/v1/health");
      return new MeasuredServer(process, awaitHealth(health, begun, process));
    } catch (IOException | InterruptedException e) {
      process.destroyForcibly();
      throw e;
    }
  }

  /** This very program: the WAR that ./toqa runs. */
  private static List<String> program() {
    String program = System.getProperty("java.class.path");
    return program.endsWith(".war")
        ? List.of("-jar", program)
        : List.of("-cp", program, "org.toqa.app.Main");
  }

  private static String java() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  /**
   * Asks until the first answer 200.
   *
   * @param begun when the process was started, by {@link System#nanoTime}
   * @param process what is to become healthy
   * @return milliseconds from there
   * @throws IOException it ends before, or is not healthy within five minutes
   */
  static double awaitHealth(URI health, long begun, Process process)
      throws IOException, InterruptedException {
    HttpRequest request = HttpRequest.newBuilder(health).timeout(TIMEOUT).build();
    try (HttpClient http = HttpClient.newHttpClient()) {
      while (process.isAlive() && System.nanoTime() - begun < LIMIT.toNanos()) {
        if (isHealthy(http, request)) {
          return (System.nanoTime() - begun) / 1e6;
        }
        TimeUnit.MILLISECONDS.sleep(POLL_MILLIS);
      }
    }
    throw new IOException(
        process.isAlive()
            ? "The server is not healthy after " + LIMIT.toMinutes() + " minutes."
            : "The server ended before it was healthy, with " + process.exitValue() + ".");
  }

  private static boolean isHealthy(HttpClient http, HttpRequest request)
      throws InterruptedException {
    try {
      return http.send(request, BodyHandlers.discarding()).statusCode() == 200;
    } catch (IOException e) {
      return false; // it does not listen yet
    }
  }

  /** From its start until it was healthy. */
  double startMillis() {
    return startMillis;
  }

  /** As a service manager ends it; returns when it is gone. */
  @Override
  public void close() {
    process.destroy();
    process.onExit().join();
  }
}
