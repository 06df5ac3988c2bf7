package org.toqa.testbed;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A Tomcat as its makers ship it, with the packaged WAR as its root application. For tests with the
 * tag {@code full}.
 */
public final class StockTomcat implements AutoCloseable {
  private static final Path SHIPPED = Path.of("target/stock-tomcat");
  private static final Duration LIMIT = Duration.ofMinutes(5);

  /** As in {@code Starting ProtocolHandler ["http-nio-127.0.0.1-auto-1-41231"]}. */
  private static final Pattern PORT =
      Pattern.compile("Starting ProtocolHandler \\[\"http-nio-.*-auto-\\d+-(\\d+)\"]");

  private final Process process;
  private final Path base;

  private StockTomcat(Process process, Path base) {
    this.process = process;
    this.base = base;
  }

  /**
   * @param base an empty folder for this Tomcat
   * @param variables what is set in its environment
   */
  public static StockTomcat start(Path base, Path war, Map<String, String> variables)
      throws IOException {
    Path home = home();
    for (String folder : List.of("conf", "webapps", "temp", "logs", "work")) {
      Files.createDirectories(base.resolve(folder));
    }
    for (String file : List.of("web.xml", "tomcat-users.xml")) {
      Files.copy(home.resolve("conf").resolve(file), base.resolve("conf").resolve(file));
    }
    Files.writeString(
        base.resolve("conf/server.xml"),
        Files.readString(home.resolve("conf/server.xml"))
            .replace("port=\"8005\"", "port=\"-1\"")
            .replace("port=\"8080\"", "address=\"127.0.0.1\" port=\"0\""));
    Files.copy(war, base.resolve("webapps/ROOT.war"));
    ProcessBuilder builder =
        new ProcessBuilder("sh", home.resolve("bin/catalina.sh").toString(), "run")
            .redirectErrorStream(true)
            .redirectOutput(base.resolve("logs/out").toFile());
    builder.environment().putAll(variables);
    builder
        .environment()
        .putAll(
            Map.of(
                "JAVA_HOME",
                System.getProperty("java.home"),
                "CATALINA_BASE",
                base.toString(),
                "CATALINA_OPTS",
                String.join(" ", ToqaProcess.JAVA_OPTIONS)));
    return new StockTomcat(builder.start(), base);
  }

  private static Path home() throws IOException {
    if (!Files.isDirectory(SHIPPED)) {
      throw new AssertionError(SHIPPED + " is missing: run ./toqa test");
    }
    try (Stream<Path> folders = Files.list(SHIPPED)) {
      return folders.findFirst().orElseThrow().toAbsolutePath();
    }
  }

  /** Of what {@link #awaitStart} has seen: its log tells the port that it has bound. */
  public URI uri() throws IOException {
    Matcher bound = PORT.matcher(log());
    if (!bound.find()) {
      throw new AssertionError("Tomcat has no port: " + log());
    }
    return URI.create("http://127.0.0.1:" + bound.group(1) + "/");
  }

  /** The same, once it has deployed what it was given. */
  public URI awaitedUri() throws IOException, InterruptedException {
    awaitStart();
    return uri();
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
