package org.toqa.app.bench;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.toqa.app.command.TemporaryFolder;
import tools.jackson.databind.JsonNode;

/** A Chromium without a screen, with a fresh profile and one page. */
final class HeadlessChromium implements AutoCloseable {
  /** Said where there is none. */
  static final String MISSING =
      "Chromium is missing: install it (Debian, Ubuntu: sudo apt-get install chromium)";

  private static final List<String> NAMES =
      List.of("chromium", "chromium-browser", "google-chrome");
  private static final Pattern LISTENING = Pattern.compile("DevTools listening on (ws://\\S+)");

  private final Process process;
  private final TemporaryFolder profile;
  private final DevToolsConnection connection;
  private final String session;

  private HeadlessChromium(
      Process process, TemporaryFolder profile, DevToolsConnection connection, String session) {
    this.process = process;
    this.profile = profile;
    this.connection = connection;
    this.session = session;
  }

  /** The program, if it is on the path. */
  static Optional<Path> find() {
    String path = System.getenv().getOrDefault("PATH", "");
    return Pattern.compile(Pattern.quote(File.pathSeparator))
        .splitAsStream(path)
        .flatMap(folder -> NAMES.stream().map(name -> Path.of(folder, name)))
        .filter(Files::isExecutable)
        .findFirst();
  }

  /**
   * @throws IOException it cannot be started
   */
  static HeadlessChromium start(Path program) throws IOException, InterruptedException {
    TemporaryFolder profile = TemporaryFolder.create("toqa-chromium");
    List<String> command =
        new ArrayList<>(
            List.of(
                program.toString(),
                "--headless",
                "--disable-gpu",
                "--no-first-run",
                "--window-size=1280,900",
                "--remote-debugging-port=0",
                "--user-data-dir=" + profile.path()));
    if (System.getProperty("user.name").equals("root")) {
      command.add("--no-sandbox"); // as root it refuses to run in its sandbox
    }
    command.add("about:blank");
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    try {
      DevToolsConnection connection = new DevToolsConnection(address(process));
      JsonNode page = connection.call("Target.createTarget", Map.of("url", "about:blank"), null);
      JsonNode attached =
          connection.call(
              "Target.attachToTarget",
              Map.of("targetId", page.path("targetId").asString(), "flatten", true),
              null);
      return new HeadlessChromium(
          process, profile, connection, attached.path("sessionId").asString());
    } catch (IOException | InterruptedException e) {
      end(process, profile);
      throw e;
    }
  }

  private static URI address(Process process) throws IOException {
    BufferedReader output = process.inputReader(StandardCharsets.UTF_8);
    for (String line = output.readLine(); line != null; line = output.readLine()) {
      Matcher listening = LISTENING.matcher(line);
      if (listening.find()) {
        // a pipe that nobody reads fills up
        Thread.ofPlatform().daemon().start(() -> output.lines().forEach(word -> {}));
        return URI.create(listening.group(1));
      }
    }
    throw new IOException("Chromium ended before it listened.");
  }

  /**
   * Opens a page.
   *
   * @param token of the API, sent with each of its requests
   * @param script is run before the page's own
   */
  void open(URI page, String token, String script) throws IOException, InterruptedException {
    connection.call("Page.enable", Map.of(), session);
    connection.call("Network.enable", Map.of(), session);
    connection.call(
        "Network.setExtraHTTPHeaders",
        Map.of("headers", Map.of("Authorization", "Bearer " + token)),
        session);
    connection.call("Page.addScriptToEvaluateOnNewDocument", Map.of("source", script), session);
    connection.call("Page.navigate", Map.of("url", page.toString()), session);
  }

  /**
   * What an expression is in the page, as JSON.
   *
   * @throws IOException it throws there
   */
  JsonNode evaluate(String expression) throws IOException, InterruptedException {
    JsonNode answer =
        connection.call(
            "Runtime.evaluate", Map.of("expression", expression, "returnByValue", true), session);
    if (answer.has("exceptionDetails")) {
      throw new IOException("The page fails: " + answer.get("exceptionDetails"));
    }
    return answer.path("result").path("value");
  }

  /** Returns when it is gone, with its profile. */
  @Override
  public void close() {
    connection.close();
    end(process, profile);
  }

  private static void end(Process process, TemporaryFolder profile) {
    List<ProcessHandle> all = process.descendants().toList();
    process.destroyForcibly().onExit().join();
    all.forEach(ProcessHandle::destroyForcibly);
    all.forEach(handle -> handle.onExit().join());
    try {
      profile.close();
    } catch (IOException e) {
      // the system empties its folder for such files
    }
  }
}
