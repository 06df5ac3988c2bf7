package org.toqa.testbed;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What was packaged, with its classes as Java has loaded and linked them once (an ahead-of-time
 * cache, JEP 483): tests start it a hundred times, and two thirds of what a start costs is that.
 * The first process that asks makes the cache; the others wait for it. How users start it is the
 * matter of {@code ToqaScriptIT}, {@code LauncherIT} and {@code DemoIT}.
 */
final class CachedProgram {
  private static final Path FOLDER = Path.of("target/ahead-of-time").toAbsolutePath();
  private static final String JAVA =
      Path.of(System.getProperty("java.home"), "bin", "java").toString();

  /** As {@code ./toqa} gives them. */
  private static final List<String> OPTIONS =
      List.of("--sun-misc-unsafe-memory-access=allow", "--enable-native-access=ALL-UNNAMED");

  private CachedProgram() {}

  /**
   * The command that runs the server's program; arguments follow.
   *
   * @param unpackedIn where the WAR unpacks itself
   */
  static synchronized List<String> server(Path unpackedIn) {
    Path war = Path.of("target/toqa.war").toAbsolutePath();
    return locked(
        () -> {
          Path cache = cacheOf(war);
          if (!Files.exists(cache)) {
            makeServerCache(war, unpackedIn, cache);
          }
          return Stream.concat(
                  serverCommand("-XX:AOTCache=" + cache, unpacked(war, unpackedIn)),
                  Stream.of("org.toqa.app.Main"))
              .toList();
        });
  }

  /** The command that runs the daemon; arguments follow. */
  static synchronized List<String> agent() {
    Path jar = Path.of("target/toqa-agent.jar").toAbsolutePath();
    return locked(
        () -> {
          Path cache = cacheOf(jar);
          if (!Files.exists(cache)) {
            makeAgentCache(jar, cache);
          }
          return agentCommand("-XX:AOTCache=" + cache, jar).toList();
        });
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
                Stream.of("org.toqa.app.Main", "server", "--port", "0", "--simulate", "1"))
            .toList();
    runOnce(folder, command, "http://");
  }

  private static void makeAgentCache(Path jar, Path cache)
      throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory("toqa-first-run");
    Path config =
        Files.writeString(
            folder.resolve("agent.yaml"),
            """
            name: first
            port: 0
            dataDir: data
            chassis: {type: simulated, start: {x: 1, y: 1, heading: 0}}
            """);
    List<String> command =
        Stream.concat(
                agentCommand("-XX:AOTCacheOutput=" + cache, jar),
                Stream.of("--config", config.toString()))
            .toList();
    runOnce(folder, command, "listening on");
  }

  private static void runOnce(Path folder, List<String> command, String whenUp)
      throws IOException, InterruptedException {
    try (ToqaProcess program = ToqaProcess.start(folder, folder, Map.of(), command)) {
      program.awaitErr(whenUp);
      program.terminate();
      program.exitCode();
    }
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
