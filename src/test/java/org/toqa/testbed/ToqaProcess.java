package org.toqa.testbed;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A command of the product in a process of its own, as a user starts it. */
public final class ToqaProcess implements AutoCloseable {
  /** When a process that does not end is given up; no answer of a test depends on it. */
  private static final Duration LIMIT = Duration.ofMinutes(10);

  /** Most commands of tests live for seconds, and are compiled for that. */
  static final List<String> JAVA_OPTIONS = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

  /** Where the WAR is unpacked once for all tests. */
  private static final Path CACHE = Path.of("target/cache").toAbsolutePath();

  private final Process process;
  private final Output out;
  private final Output err;

  private ToqaProcess(Process process) {
    this.process = process;
    this.out = new Output(process.inputReader());
    this.err = new Output(process.errorReader());
  }

  /** The launcher, run from another folder than the project's. */
  public static ToqaProcess toqa(Path folder, String... arguments) throws IOException {
    return toqa(folder, Map.of(), arguments);
  }

  /** The same, with variables in its environment. */
  public static ToqaProcess toqa(Path folder, Map<String, String> variables, String... arguments)
      throws IOException {
    String launcher = Path.of("toqa").toAbsolutePath().toString();
    Map<String, String> all = new HashMap<>(variables);
    all.put("TOQA_JAVA_OPTIONS", String.join(" ", JAVA_OPTIONS));
    List<String> command = new ArrayList<>(List.of(launcher));
    command.addAll(List.of(arguments));
    return start(folder, CACHE, all, command);
  }

  /** A server, without the launcher; for tests that are not about how it is started. */
  public static ToqaProcess server(Path folder, Map<String, String> variables, String... arguments)
      throws IOException {
    List<String> command = new ArrayList<>(CachedProgram.server(CACHE));
    command.add("server");
    command.addAll(List.of(arguments));
    return start(folder, CACHE, variables, command);
  }

  /** Any command of the server's program, without the launcher. */
  public static ToqaProcess program(Path folder, String... arguments) throws IOException {
    List<String> command = new ArrayList<>(CachedProgram.server(CACHE));
    command.addAll(List.of(arguments));
    return start(folder, CACHE, Map.of(), command);
  }

  /** A robot's daemon, without the launcher. */
  public static ToqaProcess agent(Path folder, String... arguments) throws IOException {
    List<String> command = new ArrayList<>(CachedProgram.agent(CACHE));
    command.addAll(List.of(arguments));
    return start(folder, CACHE, Map.of(), command);
  }

  /**
   * The same, run by another command.
   *
   * @param runner such as {@code ip netns exec NAME}
   */
  public static ToqaProcess agentBy(List<String> runner, Path folder, String... arguments)
      throws IOException {
    List<String> command = new ArrayList<>(runner);
    command.addAll(CachedProgram.agent(CACHE));
    command.addAll(List.of(arguments));
    return start(folder, CACHE, Map.of(), command);
  }

  /** A jar or WAR, run by this Java. */
  public static ToqaProcess jar(Path folder, Path jar, String... arguments) throws IOException {
    return jar(folder, folder.resolve("cache"), jar, arguments);
  }

  static ToqaProcess jar(Path folder, Path cache, Path jar, String... arguments)
      throws IOException {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    List<String> command = new ArrayList<>(List.of(java));
    command.addAll(JAVA_OPTIONS);
    command.addAll(List.of("-jar", jar.toAbsolutePath().toString()));
    command.addAll(List.of(arguments));
    return start(folder, cache, Map.of(), command);
  }

  /** Any command, with its caches under the folder. */
  public static ToqaProcess command(Path folder, String... command) throws IOException {
    return start(folder, folder.resolve("cache"), Map.of(), List.of(command));
  }

  static ToqaProcess start(
      Path folder, Path cache, Map<String, String> variables, List<String> command)
      throws IOException {
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().putAll(variables);
    builder.environment().put("XDG_CACHE_HOME", cache.toString());
    return new ToqaProcess(builder.start());
  }

  public long pid() {
    return process.pid();
  }

  /** Its exit code; an {@link AssertionError} where it does not end. */
  public int exitCode() throws InterruptedException {
    return exitCode(LIMIT);
  }

  /** The same for a process that works for longer. */
  public int exitCode(Duration limit) throws InterruptedException {
    if (!process.waitFor(limit.toSeconds(), TimeUnit.SECONDS)) {
      throw new AssertionError("still running; it said: " + err.all());
    }
    return process.exitValue();
  }

  /** Everything on standard output, when it has ended. */
  public List<String> out() throws InterruptedException {
    return out.atEnd();
  }

  /** Everything on standard error, when it has ended. */
  public List<String> err() throws InterruptedException {
    return err.atEnd();
  }

  /** What it has said on standard error until now. */
  public List<String> errSoFar() {
    return err.all();
  }

  /** The first line on standard error that the pattern is found in. */
  public Matcher awaitErr(String pattern) throws InterruptedException {
    return err.await(Pattern.compile(pattern));
  }

  /** Asks it to end, as Ctrl-C and a service manager do. */
  public void terminate() {
    process.toHandle().destroy(); // unlike Process.destroy it leaves the output open
  }

  /** Ends it as {@code kill -9} does, and waits until it is gone. */
  public void kill() throws InterruptedException {
    process.destroyForcibly().waitFor();
  }

  /** Lets it do nothing, and answer nothing, until {@link #thaw}; its connections stay open. */
  public void freeze() throws IOException, InterruptedException {
    signal("STOP");
  }

  public void thaw() throws IOException, InterruptedException {
    signal("CONT");
  }

  private void signal(String name) throws IOException, InterruptedException {
    int code = new ProcessBuilder("kill", "-" + name, String.valueOf(pid())).start().waitFor();
    if (code != 0) {
      throw new IOException("kill -" + name + " ended with " + code);
    }
  }

  @Override
  public void close() {
    process.destroyForcibly();
  }

  private static final class Output {
    private final List<String> lines = new ArrayList<>();
    private final Thread reader;
    private boolean isAtEnd;

    Output(BufferedReader source) {
      // no virtual thread: reading a pipe holds its carrier, and a pipe that nobody reads fills up
      reader = Thread.ofPlatform().daemon().start(() -> read(source));
    }

    private void read(BufferedReader source) {
      try {
        source.lines().forEach(this::add);
      } catch (UncheckedIOException e) {
        // told to end from here, which closes the pipe: what it said last is not known
      } finally {
        end();
      }
    }

    private synchronized void add(String line) {
      lines.add(line);
      notifyAll();
    }

    private synchronized void end() {
      isAtEnd = true;
      notifyAll();
    }

    synchronized List<String> all() {
      return List.copyOf(lines);
    }

    List<String> atEnd() throws InterruptedException {
      if (!reader.join(LIMIT)) {
        throw new AssertionError("the stream is still open after: " + all());
      }
      return all();
    }

    synchronized Matcher await(Pattern pattern) throws InterruptedException {
      long end = System.nanoTime() + LIMIT.toNanos();
      int seen = 0;
      while (true) {
        for (; seen < lines.size(); seen++) {
          Matcher matcher = pattern.matcher(lines.get(seen));
          if (matcher.find()) {
            return matcher;
          }
        }
        long left = end - System.nanoTime();
        if (left <= 0 || isAtEnd) {
          throw new AssertionError("no line with " + pattern + " in: " + lines);
        }
        TimeUnit.NANOSECONDS.timedWait(this, left);
      }
    }
  }
}
