package org.toqa.testbed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.extension.AnnotatedElementContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.io.TempDirFactory;

/**
 * A folder in memory where the system has one: for tests that would wait for the disk all day. The
 * full suite chooses where, and removes it when it is killed.
 */
public final class MemoryFolder implements TempDirFactory {

  private static final Path MEMORY = Path.of(System.getProperty("toqa.memory", "/dev/shm"));

  @Override
  public Path createTempDirectory(AnnotatedElementContext element, ExtensionContext test)
      throws IOException {
    return Files.isWritable(MEMORY)
        ? Files.createTempDirectory(MEMORY, "toqa")
        : Files.createTempDirectory("toqa");
  }
}
