package org.toqa.endtoend;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import org.toqa.store.MigratedFile;
import org.toqa.testbed.ApiClient;
import org.toqa.testbed.ApiClient.Reply;
import org.toqa.testbed.CheapPassword;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;

/** A server process that is killed and started again, with a manager logged in. */
final class RunningServer implements AutoCloseable {
  static final String MANAGER = "boss";
  static final String PASSWORD = "boss-of-robots";
  private static final String PASSWORD_HASH = CheapPassword.hash(PASSWORD);
  private static final Duration TIMEOUT = Duration.ofMinutes(10);

  private final Path folder;
  private final String[] arguments;
  private final List<ToqaProcess> killed = new ArrayList<>();
  private ToqaProcess process;
  private ApiClient api;
  private URI root;

  RunningServer(Path folder, String... arguments) throws Exception {
    this.folder = folder;
    Path data = folder.resolve("data");
    if (!Files.exists(data)) {
      MigratedFile.copyTo(data);
    }
    List<String> command = new ArrayList<>(List.of("--port", "0", "--data"));
    command.add(data.toString());
    command.addAll(List.of(arguments));
    this.arguments = command.toArray(String[]::new);
    process = launch();
    try {
      root = URI.create(process.awaitErr("http://[^ ]*").group());
      api = new ApiClient(root, MANAGER, PASSWORD);
    } catch (Exception | AssertionError e) { // nobody else has it, to end it
      process.close();
      throw e;
    }
  }

  private ToqaProcess launch() throws Exception {
    return ToqaProcess.server(
        folder, Map.of("TOQA_MANAGER", MANAGER + ":" + PASSWORD_HASH), arguments);
  }

  ApiClient api() {
    return api;
  }

  URI root() {
    return root;
  }

  /** The first line of its log that the pattern is found in. */
  Matcher awaitErr(String pattern) throws InterruptedException {
    return process.awaitErr(pattern);
  }

  /** As {@code kill -9} does it, and then as a user starts it again. */
  void killAndRestart() throws Exception {
    kill();
    start();
  }

  void kill() throws Exception {
    process.kill();
    killed.add(process);
    api.close();
  }

  /** As a service manager does it. */
  void stop() throws Exception {
    process.terminate();
    process.exitCode();
    killed.add(process);
    api.close();
  }

  void start() throws Exception {
    process = launch();
    root = URI.create(process.awaitErr("http://[^ ]*").group());
    api = new ApiClient(root, MANAGER, PASSWORD);
  }

  /** Everything on standard error of the servers that were killed or stopped. */
  List<String> errorOutput() throws InterruptedException {
    List<String> lines = new ArrayList<>();
    for (ToqaProcess server : killed) {
      lines.addAll(server.err());
    }
    return lines;
  }

  long addTask(String name, String start, String goal) throws Exception {
    return api.post("tasks", order(name, start, goal)).get("id").asLong();
  }

  static Map<String, Object> order(String name, String start, String goal) {
    return Map.of(
        "name",
        name,
        "load",
        2,
        "start",
        Map.of("station", start),
        "goal",
        Map.of("station", goal));
  }

  JsonNode task(long id) throws Exception {
    return api.get("tasks/" + id);
  }

  String state(long id) throws Exception {
    return task(id).get("state").asString();
  }

  void awaitState(long id, String state) throws Exception {
    await("tasks/" + id, task -> task.get("state").asString().equals(state));
  }

  /** Also while its database comes back. */
  JsonNode await(String path, Predicate<JsonNode> condition) throws Exception {
    long end = System.nanoTime() + TIMEOUT.toNanos();
    while (true) {
      Optional<JsonNode> answer = api.tryToGet(path);
      if (answer.filter(condition).isPresent()) {
        return answer.get();
      }
      if (System.nanoTime() > end) {
        throw new AssertionError(
            path + " still says " + answer + " while the robots are " + api.get("robots"));
      }
      TimeUnit.MILLISECONDS.sleep(50);
    }
  }

  /** Commands until it is accepted, also while its database comes back; what it answers. */
  JsonNode awaitAccepted(String path, Map<String, Object> order) throws Exception {
    long end = System.nanoTime() + TIMEOUT.toNanos();
    while (true) {
      Reply reply = api.replyTo(path, order);
      if (reply.isAccepted()) {
        return reply.body();
      }
      if (!reply.isUnavailable() || System.nanoTime() > end) {
        throw new AssertionError(path + ": " + reply);
      }
      TimeUnit.MILLISECONDS.sleep(50);
    }
  }

  /** What it has logged last. */
  List<String> lastLines(int count) {
    List<String> lines = process.errSoFar();
    return lines.subList(Math.max(0, lines.size() - count), lines.size());
  }

  /** How often the task's history has a line that begins so. */
  long eventCount(long id, String beginning) throws Exception {
    return eventCount(task(id), beginning);
  }

  /** Of a task as the API shows it. */
  static long eventCount(JsonNode task, String beginning) {
    long count = 0;
    for (JsonNode event : task.get("history")) {
      count += event.get("text").asString().startsWith(beginning) ? 1 : 0;
    }
    return count;
  }

  @Override
  public void close() {
    api.close();
    process.close();
  }
}
