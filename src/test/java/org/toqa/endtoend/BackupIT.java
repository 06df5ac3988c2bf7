package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A server is put back to a backup, as docs/operations.md says, while its robot has gone on. */
@Tag("full")
@Execution(ExecutionMode.CONCURRENT)
class BackupIT {
  @TempDir private Path folder;

  @Test
  void theFolderOfAServerThatIsStoppedHoldsAll() throws Exception {
    Path data = folder.resolve("data");
    Path backup = folder.resolve("data.backup");
    try (RunningServer server = new RunningServer(folder, "--simulate", "1", "--speed", "20")) {
      BackupScenario work = BackupScenario.start(server);
      server.stop();
      copyFolder(data, backup);
      server.start();
      work.workAfterBackup();
      server.stop();
      Files.move(data, folder.resolve("data.lost"));
      copyFolder(backup, data);
      server.start();

      work.assertRestoredAndContinues();
    }
  }

  @Test
  void aRobotThatIsAheadOfTheRestoredServerIsUsedAgain() throws Exception {
    Path data = folder.resolve("data");
    Path backup = Files.createDirectory(folder.resolve("backup"));
    try (RunningServer server = new RunningServer(folder, "--simulate", "1", "--speed", "20")) {
      long first = server.addTask("in the backup", "Workbench 1", "Packing 1");
      server.awaitState(first, "DONE");
      server.kill();
      copyDatabase(data, backup);
      server.start();
      long second = server.addTask("not in the backup", "Workbench 1", "Packing 1");
      server.awaitState(second, "CARRYING");
      server.kill();
      copyDatabase(backup, data);
      server.start();

      server.await("robots", robots -> robots.get(0).get("state").asString().equals("IDLE"));
      assertEquals(1, server.api().get("tasks").size());
      assertEquals("DONE", server.state(first));
      long third = server.addTask("after it", "Workbench 1", "Packing 1");
      server.awaitState(third, "DONE");
    }
  }

  private static void copyFolder(Path from, Path to) throws Exception {
    Process copy = new ProcessBuilder("cp", "-a", from.toString(), to.toString()).start();
    assertEquals(0, copy.waitFor());
  }

  private static void copyDatabase(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.list(to)) {
      for (Path file : files.filter(BackupIT::isOfDatabase).toList()) {
        Files.delete(file);
      }
    }
    List<Path> kept;
    try (Stream<Path> files = Files.list(from)) {
      kept = files.filter(BackupIT::isOfDatabase).toList();
    }
    for (Path file : kept) {
      Files.copy(file, to.resolve(file.getFileName()));
    }
    assertEquals(1, kept.size(), () -> "" + kept);
  }

  private static boolean isOfDatabase(Path file) {
    return file.getFileName().toString().startsWith("toqa.");
  }
}
