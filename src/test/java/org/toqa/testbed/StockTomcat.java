package org.toqa.testbed;

import java.io.IOException;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A Tomcat as its makers ship it, with the packaged WAR as its root application. For tests with the
 * tag {@code full}.
 */
public final class StockTomcat implements AutoCloseable {
  private static final Path SHIPPED = Path.of("target/stock-tomcat");
  private static final Duration LIMIT = Duration.ofSeconds(60);

  private final Process process;
  private final Path base;
  private final int port;

  private StockTomcat(Process process, Path base, int port) {
    this.process = process;
    this.base = base;
    this.port = port;
  }

  /**
   * @param base an empty folder for this Tomcat
   */
  public static StockTomcat start(Path base, Path war) throws IOException {
    Path home = home();
    for (String folder : List.of("conf", "webapps", "temp", "logs", "work")) {
      Files.createDirectories(base.resolve(folder));
    }
    for (String file : List.of("web.xml", "tomcat-users.xml")) {
      Files.copy(home.resolve("conf").resolve(file), base.resolve("conf").resolve(file));
    }
    int port = freePort();
    Files.writeString(
        base.resolve("conf/server.xml"),
        Files.readString(home.resolve("conf/server.xml"))
            .replace("port=\"8005\"", "port=\"-1\"")
            .replace("port=\"8080\"", "address=\"127.0.0.1\" port=\"" + port + "\""));
    Files.copy(war, base.resolve("webapps/ROOT.war"));
    ProcessBuilder builder =
        new ProcessBuilder("sh", home.resolve("bin/catalina.sh").toString(), "run")
            .redirectErrorStream(true)
            .redirectOutput(base.resolve("logs/out").toFile());
    builder
        .environment()
        .putAll(
            Map.of("JAVA_HOME", System.getProperty("java.home"), "CATALINA_BASE", base.toString()));
    return new StockTomcat(builder.start(), base, port);
  }

  private static Path home() throws IOException {
    if (!Files.isDirectory(SHIPPED)) {
      throw new AssertionError(SHIPPED + " is missing: run ./toqa test");
    }
    try (Stream<Path> folders = Files.list(SHIPPED)) {
      return folders.findFirst().orElseThrow().toAbsolutePath();
    }
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0)) {
      return socket.getLocalPort();
    }
  }

  public URI uri() {
    return URI.create("http://127.0.0.1:" + port + "/");
  }

  public String log() throws IOException {
    return Files.readString(base.resolve("logs/out"));
  }

  /** It has deployed what it was given, with success or not. */
  public void awaitStart() throws IOException, InterruptedException {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (!log().contains("Server startup in")) {
      if (System.nanoTime() > end || process.waitFor(100, TimeUnit.MILLISECONDS)) {
        throw new AssertionError("Tomcat did not start: " + log());
      }
    }
  }

  /** Ends it in order, so that the application is told. */
  public void stop() throws InterruptedException {
    process.destroy();
    if (!process.waitFor(LIMIT.toSeconds(), TimeUnit.SECONDS)) {
      throw new AssertionError("Tomcat did not end");
    }
  }

  @Override
  public void close() {
    process.destroyForcibly();
  }
}
