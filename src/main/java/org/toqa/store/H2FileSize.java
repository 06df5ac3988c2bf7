package org.toqa.store;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.h2.mvstore.MVStoreException;
import org.h2.mvstore.MVStoreTool;

/**
 * What the file of an H2 database takes, and what of that is needed.
 *
 * @param bytes of the file
 * @param contentBytes of a compacted copy of it
 */
public record H2FileSize(long bytes, long contentBytes) {

  /**
   * Measures a file, which may be in use: a copy of it is as good as what a killed process leaves.
   *
   * @param file its name ends with {@code .mv.db}
   * @throws IOException it cannot be read or copied, or is not such a file
   */
  public static H2FileSize of(Path file) throws IOException {
    Path folder = Files.createTempDirectory("toqa-size");
    Path copy = folder.resolve("copy.mv.db");
    try {
      Files.copy(file, copy);
      long bytes = Files.size(copy);
      MVStoreTool.compact(copy.toString(), false);
      return new H2FileSize(bytes, Files.size(copy));
    } catch (MVStoreException e) {
      throw new IOException(file + " is no database of H2: " + e.getMessage(), e);
    } finally {
      Files.deleteIfExists(copy);
      Files.delete(folder);
    }
  }
}
