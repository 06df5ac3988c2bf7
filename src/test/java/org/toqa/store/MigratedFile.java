package org.toqa.store;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The file of a database with the shipped tables and nothing in them, migrated once in a process: a
 * server that begins with a copy of it starts with three quarters of the work. That it makes its
 * own is the matter of {@code ToqaScriptIT} and {@code FirstPageIT}.
 */
public final class MigratedFile {
  private static final String NAME = "toqa";
  private static final String ENDING = ".mv.db";
  private static final byte[] CONTENT = content();

  private MigratedFile() {}

  /**
   * Copies it to where a server looks for it.
   *
   * @param data the server's folder, which is made
   */
  public static void copyTo(Path data) throws IOException {
    Files.write(Files.createDirectories(data).resolve(NAME + ENDING), CONTENT);
  }

  private static byte[] content() {
    try {
      Path folder = Files.createTempDirectory("toqa-migrated");
      Database.open(Database.fileUrl(folder.resolve(NAME)), "", "").close();
      Path file = folder.resolve(NAME + ENDING);
      byte[] content = Files.readAllBytes(file);
      Files.delete(file);
      Files.delete(folder);
      return content;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
