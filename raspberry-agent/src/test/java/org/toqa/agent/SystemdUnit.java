package org.toqa.agent;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** What a unit file of systemd says; of each key the last line counts (systemd.syntax(7)). */
record SystemdUnit(Map<String, String> settings) {

  static SystemdUnit read(Path file) throws IOException {
    Map<String, String> settings = new HashMap<>();
    String section = "";
    for (String line : Files.readAllLines(file)) {
      if (line.startsWith("[")) {
        section = line;
      } else if (!line.isBlank() && !line.startsWith("#")) {
        int equals = line.indexOf('=');
        settings.put(section + line.substring(0, equals), line.substring(equals + 1));
      }
    }
    return new SystemdUnit(settings);
  }

  /** Of the section Service. */
  String service(String key) {
    String value = settings.get("[Service]" + key);
    if (value == null) {
      throw new AssertionError("the unit does not say " + key);
    }
    return value;
  }

  /** The program and its arguments; nothing in it is quoted. */
  List<String> command() {
    return List.of(service("ExecStart").split(" +"));
  }

  /**
   * How systemd starts it where its whole file system begins in a folder: each path is one in that
   * folder, and there are no variables but those that systemd sets.
   */
  List<String> commandIn(Path root) {
    List<String> words =
        new ArrayList<>(
            List.of("env", "-i", "PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin"));
    if (settings.containsKey("[Service]Environment")) {
      words.addAll(List.of(service("Environment").split(" +")));
    }
    for (String word : command()) {
      words.add(word.startsWith("/") ? root + word : word);
    }
    return words;
  }

  /** After {@code kill -9}, as when its memory ran out (systemd.service(5), Restart=). */
  boolean isRestartedWhenKilled() {
    return Set.of("always", "on-failure", "on-abnormal", "on-abort").contains(service("Restart"));
  }

  /** After it ended with a code that tells of an error. */
  boolean isRestartedWhenFailed() {
    return Set.of("always", "on-failure").contains(service("Restart"));
  }

  /** Whether this is no error to systemd. */
  boolean isSuccess(int exitCode) {
    return exitCode == 0
        || List.of(service("SuccessExitStatus").split(" +")).contains(String.valueOf(exitCode));
  }

  /** Seconds, written as a bare number. */
  long seconds(String key) {
    return Long.parseLong(service(key));
  }
}
