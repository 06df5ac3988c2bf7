package org.toqa.store;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.File;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.RobotRecord;

/**
 * A process that has the embedded database ends in the middle of its work, again and again: all
 * that it was told to be stored is there. Once parts of the file are used again, H2 2.5.252 lost
 * the last commits in every third run.
 */
@Tag("full")
class H2KilledTest {
  private static final int RUNS = 10;
  private static final int GROUP_RUNS = 5;

  /** Until it is killed; the first ones are those of drives that begin. */
  private static final int LEAST_LINES = 500;

  private static final int MOST_LINES = 3000;

  @TempDir private Path folder;

  @Test
  @Timeout(300)
  void whatWasStoredIsThere() throws Exception {
    try (Database database = open()) {
      new JdbiFleetStore(database.jdbi())
          .saveRobot(
              new RobotRecord(CommittingProcess.ROBOT, "lab", "127.0.0.1", 1, 5, null, true, null));
    }
    long last = 0;
    for (int run = 1; run <= RUNS; run++) {
      last = lastStoredBy(process(CommittingProcess.class, last + 1));
      try (Database database = open()) {
        long stored =
            new JdbiFleetStore(database.jdbi()).drive(CommittingProcess.ROBOT).orElseThrow().seq();
        assertEquals(last, stored, "after run " + run);
      }
    }
  }

  /**
   * Many robots' changes go into one transaction, and the process is killed at any moment: of each
   * robot all is there that was told, as it was written, and at most the one change more that was
   * under way.
   */
  @Test
  @Timeout(300)
  void whatWasToldOfAGroupIsThere() throws Exception {
    try (Database database = open()) {
      JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
      GroupCommittingProcess.ROBOTS.forEach(
          robot ->
              store.saveRobot(new RobotRecord(robot, "lab", "127.0.0.1", 1, 5, null, true, null)));
    }
    long first = 1;
    for (int run = 1; run <= GROUP_RUNS; run++) {
      Map<String, Told> told = toldUntilKilled(first);
      try (Database database = open()) {
        JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
        for (String robot : GroupCommittingProcess.ROBOTS) {
          StoredDrive stored = store.drive(robot).orElseThrow();
          assertEquals(
              ScriptedDrives.extended(robot, stored.seq(), stored.extensions()), stored, robot);
          Told last = requireNonNull(told.get(robot));
          long changesMore =
              GroupCommittingProcess.CHANGES_A_DRIVE * (stored.seq() - last.drive())
                  + stored.extensions()
                  - last.extension();
          assertTrue(changesMore == 0 || changesMore == 1, robot + ": " + changesMore);
          first = Math.max(first, stored.seq() + 1);
        }
      }
    }
  }

  /** The last that was told of a robot. */
  private record Told(long drive, int extension) {}

  private Map<String, Told> toldUntilKilled(long first) throws Exception {
    Process process = process(GroupCommittingProcess.class, first);
    int lines = ThreadLocalRandom.current().nextInt(LEAST_LINES, MOST_LINES);
    Map<String, Told> told = new HashMap<>();
    try (BufferedReader reader = process.inputReader()) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        String[] words = line.split(" ", -1);
        if (words.length == 4) { // else it was killed within it
          told.put(words[0], new Told(Long.parseLong(words[1]), Integer.parseInt(words[2])));
        }
        lines--;
        if (lines == 0) {
          process.toHandle().destroyForcibly(); // else what it has said were lost
        }
      }
    }
    process.waitFor(1, TimeUnit.MINUTES);
    assertEquals(137, process.exitValue(), "killed by the test");
    assertEquals(Set.copyOf(GroupCommittingProcess.ROBOTS), told.keySet());
    return told;
  }

  private static long lastStoredBy(Process process) throws Exception {
    List<String> lines = process.inputReader().lines().toList();
    process.waitFor(1, TimeUnit.MINUTES);
    assertEquals(137, process.exitValue());
    return Long.parseLong(lines.getLast());
  }

  private Process process(Class<?> program, long first) throws Exception {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1",
            "-XX:+UseSerialGC",
            "--sun-misc-unsafe-memory-access=allow",
            "-cp",
            System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
            program.getName(),
            file().toString(),
            String.valueOf(first))
        .redirectError(new File(folder.toFile(), "errors"))
        .start();
  }

  private Database open() {
    return CommittingProcess.open(file());
  }

  private Path file() {
    return folder.resolve("toqa");
  }
}
