package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.fleet.RobotRecord;

/**
 * A process that has the embedded database ends in the middle of its work, again and again: all
 * that it was told to be stored is there. Once parts of the file are used again, H2 2.5.252 lost
 * the last commits in every third run.
 */
@Tag("full")
class H2KilledTest {
  private static final int RUNS = Math.min(5 * Integer.getInteger("toqa.tries", 1), 20);

  @TempDir private Path folder;

  @Test
  @Timeout(1200)
  void whatWasStoredIsThere() throws Exception {
    try (Database database = open()) {
      new JdbiFleetStore(database.jdbi())
          .saveRobot(
              RobotRecord.direct(
                  CommittingProcess.ROBOT, "lab", "127.0.0.1", 1, 5, null, true, null));
    }
    long last = 0;
    for (int run = 1; run <= RUNS; run++) {
      last = lastStoredBy(process(last + 1));
      try (Database database = open()) {
        long stored =
            new JdbiFleetStore(database.jdbi()).drive(CommittingProcess.ROBOT).orElseThrow().seq();
        assertEquals(last, stored, "after run " + run);
      }
    }
  }

  private static long lastStoredBy(Process process) throws Exception {
    List<String> lines = process.inputReader().lines().toList();
    process.waitFor(1, TimeUnit.MINUTES);
    assertEquals(137, process.exitValue());
    return Long.parseLong(lines.getLast());
  }

  private Process process(long first) throws Exception {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1",
            "-XX:+UseSerialGC",
            "--sun-misc-unsafe-memory-access=allow",
            "-cp",
            System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
            CommittingProcess.class.getName(),
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
