package org.toqa.testbed;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What was packaged, with its classes as Java has loaded and linked them once, while a robot
 * carried a task (an ahead-of-time cache, JEP 483): tests start it a hundred times, and two thirds
 * of what a start costs is that. The first process that asks makes the cache; the others wait for
 * it. How users start it is the matter of {@code ToqaScriptIT}, {@code LauncherIT} and {@code
 * DemoIT}.
 */
final class CachedProgram {
  private static final Path FOLDER = Path.of("target/ahead-of-time").toAbsolutePath();
  private static final String JAVA =
      Path.of(System.getProperty("java.home"), "bin", "java").toString();

  /** As {@code ./toqa} gives them. */
  private static final List<String> OPTIONS =
      List.of("--sun-misc-unsafe-memory-access=allow", "--enable-native-access=ALL-UNNAMED");

  private static final String USER = "first";
  private static final String PASSWORD = "first-of-all";
  private static final String SPEED = "20";

  private CachedProgram() {}

  /**
   * The command that runs the server's program; arguments follow.
   *
   * @param unpackedIn where the WAR unpacks itself
   */
  static synchronized List<String> server(Path unpackedIn) {
    return locked(() -> cachedServer(unpackedIn));
  }

  /**
   * The command that runs the daemon; arguments follow.
   *
   * @param unpackedIn where the WAR unpacks itself
   */
  static synchronized List<String> agent(Path unpackedIn) {
    Path jar = Path.of("target/toqa-agent.jar").toAbsolutePath();
    return locked(
        () -> {
          Path cache = cacheOf(jar);
          if (!Files.exists(cache)) {
            makeAgentCache(jar, cachedServer(unpackedIn), cache);
          }
          return agentCommand("-XX:AOTCache=" + cache, jar).toList();
        });
  }

  private static List<String> cachedServer(Path unpackedIn)
      throws IOException, InterruptedException {
    Path war = Path.of("target/toqa.war").toAbsolutePath();
    Path cache = cacheOf(war);
    if (!Files.exists(cache)) {
      makeServerCache(war, unpackedIn, cache);
    }
    return Stream.concat(
            serverCommand("-XX:AOTCache=" + cache, unpacked(war, unpackedIn)),
            Stream.of("org.toqa.app.Main"))
        .toList();
  }

  private interface Step<T> {
    T take() throws IOException, InterruptedException;
  }

  private static <T> T locked(Step<T> step) {
    try {
      Files.createDirectories(FOLDER);
      try (FileChannel channel =
          FileChannel.open(
              FOLDER.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
        channel.lock();
        return step.take();
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  /** Of another build: another one. */
  private static Path cacheOf(Path archive) throws IOException {
    return FOLDER.resolve(archive.getFileName() + "-" + version(archive) + ".aot");
  }

  private static String version(Path archive) throws IOException {
    return Files.size(archive) + "-" + Files.getLastModifiedTime(archive).toMillis();
  }

  private static Path unpacked(Path war, Path unpackedIn) throws IOException {
    try (Stream<Path> all = Files.walk(unpackedIn.resolve("toqa"), 2)) {
      String version = version(war);
      return all.filter(path -> path.getFileName().toString().equals(version))
          .findFirst()
          .orElseThrow();
    }
  }

  private static Stream<String> serverCommand(String option, Path unpacked) throws IOException {
    Path inside = unpacked.resolve("WEB-INF");
    List<Path> jars = new ArrayList<>(List.of(FOLDER.resolve("classes.jar")));
    for (String part : List.of("lib", "server")) {
      try (Stream<Path> files = Files.list(inside.resolve(part))) {
        files.sorted().forEach(jars::add);
      }
    }
    String classPath = jars.stream().map(Path::toString).collect(Collectors.joining(":"));
    return Stream.of(
            Stream.of(JAVA),
            OPTIONS.stream(),
            ToqaProcess.JAVA_OPTIONS.stream(),
            Stream.of(option, "-Dtoqa.webapp=" + unpacked, "-cp", classPath))
        .flatMap(words -> words);
  }

  private static Stream<String> agentCommand(String option, Path jar) {
    return Stream.of(
            Stream.of(JAVA, "-Xmx64m"),
            OPTIONS.stream(),
            ToqaProcess.JAVA_OPTIONS.stream(),
            Stream.of(option, "-jar", jar.toString()))
        .flatMap(words -> words);
  }

  private static void makeServerCache(Path war, Path unpackedIn, Path cache)
      throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory("toqa-first-run");
    try (ToqaProcess help = ToqaProcess.jar(folder, unpackedIn, war, "--help")) {
      help.exitCode();
    }
    Path unpacked = unpacked(war, unpackedIn);
    // what is in a folder is never cached
    jar(FOLDER.resolve("classes.jar"), unpacked.resolve("WEB-INF/classes"));
    List<String> command =
        Stream.concat(
                serverCommand("-XX:AOTCacheOutput=" + cache, unpacked),
                Stream.of("org.toqa.app.Main"))
            .toList();
    try (ToqaProcess server = startServer(folder, command);
        ApiClient api = logIn(server)) {
      carry(api, List.of(Map.entry("Store A", "Store B")));
      end(server);
    }
  }

  private static void makeAgentCache(Path jar, List<String> server, Path cache)
      throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory("toqa-first-run");
    Path config =
        Files.writeString(
            folder.resolve("agent.yaml"),
            """
            name: first
            port: 0
            dataDir: data
            chassis: {type: simulated, speed: %s, start: {x: 7.95, y: 3.15, heading: 0}}
            """
                .formatted(SPEED));
    List<String> command =
        Stream.concat(
                agentCommand("-XX:AOTCacheOutput=" + cache, jar),
                Stream.of("--config", config.toString()))
            .toList();
    try (ToqaProcess daemon = ToqaProcess.start(folder, folder, Map.of(), command);
        ToqaProcess running = startServer(folder, server);
        ApiClient api = logIn(running)) {
      int port = Integer.parseInt(daemon.awaitErr("listening on .* port (\\d+)").group(1));
      api.post("robots", Map.of("name", "first", "host", "127.0.0.1", "port", port, "maxLoad", 5));
      carry(api, List.of(Map.entry("Store A", "Store B"), Map.entry("Goods-in 1", "Mill")));
      end(daemon);
      end(running);
    }
  }

  /** With a robot of its own. */
  private static ToqaProcess startServer(Path folder, List<String> program) throws IOException {
    List<String> command = new ArrayList<>(program);
    command.addAll(List.of("server", "--port", "0", "--simulate", "1", "--speed", SPEED));
    command.addAll(List.of("--data", folder.resolve("server").toString()));
    String manager = USER + ":" + CheapPassword.hash(PASSWORD);
    return ToqaProcess.start(folder, folder, Map.of("TOQA_MANAGER", manager), command);
  }

  private static ApiClient logIn(ToqaProcess server) throws IOException, InterruptedException {
    URI root = URI.create(server.awaitErr("http://[^ ]*").group());
    return new ApiClient(root, USER, PASSWORD);
  }

  /** As many robots as there are tasks carry one each. */
  private static void carry(ApiClient api, List<Map.Entry<String, String>> ways)
      throws IOException, InterruptedException {
    await(api, "robots", "IDLE", ways.size());
    for (Map.Entry<String, String> way : ways) {
      Map<String, Object> order =
          Map.of(
              "name",
              way.toString(),
              "load",
              1,
              "start",
              Map.of("station", way.getKey()),
              "goal",
              Map.of("station", way.getValue()));
      api.post("tasks", order);
    }
    await(api, "tasks", "DONE", ways.size());
  }

  private static void await(ApiClient api, String list, String state, int count)
      throws IOException, InterruptedException {
    long found = 0;
    while (found < count) {
      TimeUnit.MILLISECONDS.sleep(50);
      found =
          api.get(list)
              .valueStream()
              .filter(one -> one.get("state").asString().equals(state))
              .count();
    }
  }

  private static void end(ToqaProcess program) throws InterruptedException {
    program.terminate();
    program.exitCode();
  }

  private static void jar(Path file, Path classes) {
    PrintStream out = new PrintStream(System.err, true, StandardCharsets.UTF_8);
    int code =
        ToolProvider.findFirst("jar")
            .orElseThrow()
            .run(out, out, "--create", "--file", file.toString(), "-C", classes.toString(), ".");
    if (code != 0) {
      throw new IllegalStateException("jar ended with " + code);
    }
  }
}
