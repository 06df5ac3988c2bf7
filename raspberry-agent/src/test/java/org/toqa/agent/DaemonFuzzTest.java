package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.FuzzRun;
import org.toqa.testbed.LogLevel;
import org.toqa.testbed.MemoryFolder;

/**
 * Lines of every kind through the daemon's own listener, over a real socket, by a server and by a
 * leader. {@link FuzzedRobot} checks what each of them does.
 */
class DaemonFuzzTest {

  private static final int LINES_AT_ONCE = 50;
  private static final int LINES_TO_A_DRIVE = 200;
  private static final int LINES_TO_A_DAEMON = 4_000;
  private static final Duration BETWEEN_LINES = Duration.ofMillis(100);

  /** What is left of a whole daemon, its lines and the virtual machine's own needs. */
  private static final long MOST_BYTES_MORE = 64L << 20;

  @TempDir(factory = MemoryFolder.class)
  Path folder;

  private final LogLevel silence = LogLevel.errors("org.toqa.agent");

  @AfterEach
  void speakAgain() {
    silence.close();
  }

  @Test
  void onlyLegalOrdersMoveTheRobot() {
    long begin = System.nanoTime();
    long lines = 0;
    long memory = -1;
    FuzzedRobot.Count count = new FuzzedRobot.Count();
    while (lines < FuzzRun.INPUTS) {
      Path data = folder.resolve("r" + lines);
      try (FuzzedRobot robot = new FuzzedRobot(data, FuzzRun.SEED + lines, count)) {
        long end = Math.min(FuzzRun.INPUTS, lines + LINES_TO_A_DAEMON);
        while (lines < end && !robot.isOutOfNumbers()) {
          robot.receiveLines(LINES_AT_ONCE, BETWEEN_LINES);
          lines += LINES_AT_ONCE;
          if (lines % LINES_TO_A_DRIVE == 0 && !robot.isOutOfNumbers()) {
            robot.bringToStandstill();
          }
        }
      }
      memory = memory < 0 ? usedBytes() : memory;
    }

    assertTrue(usedBytes() - memory < MOST_BYTES_MORE);
    assertTrue(count.obeyed() > lines / 100, "hardly a line was obeyed: " + count);
    assertEquals(lines, count.lines());
    FuzzRun.tell("the daemon", lines, count.toString(), begin);
  }

  private static long usedBytes() {
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }
}
