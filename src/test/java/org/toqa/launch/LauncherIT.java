package org.toqa.launch;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ToqaProcess;

/** The executable WAR, started by {@code java -jar}. */
@Tag("full")
class LauncherIT {
  @TempDir private Path folder;

  @BeforeEach
  void copyTheWar() throws IOException {
    Files.copy(Path.of("target/toqa.war"), war());
  }

  @Test
  void theWarIsUnpackedOnce() throws Exception {
    runOnce();
    FileTime first = Files.getLastModifiedTime(unpacked().findFirst().orElseThrow());
    runOnce();

    assertEquals(1, unpacked().count());
    assertEquals(first, Files.getLastModifiedTime(unpacked().findFirst().orElseThrow()));
  }

  @Test
  void aNewVersionReplacesTheOldOne() throws Exception {
    runOnce();
    Path old = unpacked().findFirst().orElseThrow();
    becomeNewVersion();
    runOnce();

    assertEquals(1, unpacked().filter(version -> !version.equals(old)).count());
    assertEquals(1, unpacked().count());
  }

  @Test
  void aVersionThatStillRunsIsKept() throws Exception {
    try (ToqaProcess server = ToqaProcess.jar(folder, war(), "server", "--port", "0")) {
      server.awaitErr("http://");
      becomeNewVersion();
      runOnce();

      assertEquals(2, unpacked().count());
    }
  }

  @Test
  void anOldJavaCanReadTheLauncher() throws IOException {
    try (JarFile jar = new JarFile(war().toFile());
        DataInputStream bytes =
            new DataInputStream(
                jar.getInputStream(jar.getEntry("org/toqa/launch/Launcher.class")))) {
      bytes.skipNBytes(6); // magic number and minor version
      assertEquals(55, bytes.readUnsignedShort()); // class files of Java 11
    }
  }

  private void runOnce() throws Exception {
    try (ToqaProcess help = ToqaProcess.jar(folder, war(), "--help")) {
      assertEquals(0, help.exitCode(), () -> "exit code");
    }
  }

  private void becomeNewVersion() throws IOException {
    Files.setLastModifiedTime(war(), FileTime.from(Instant.parse("2030-01-01T00:00:00Z")));
  }

  private Path war() {
    return folder.resolve("toqa.war");
  }

  private Stream<Path> unpacked() throws IOException {
    try (Stream<Path> all = Files.walk(folder.resolve("cache/toqa"), 2)) {
      return all.filter(path -> Files.isDirectory(path.resolve("WEB-INF"))).toList().stream();
    }
  }
}
