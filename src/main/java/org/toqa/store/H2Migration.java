package org.toqa.store;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.sql.Connection;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.function.Consumer;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import javax.sql.DataSource;
import org.h2.api.ErrorCode;
import org.jdbi.v3.core.ConnectionException;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;

/**
 * Brings the file of an H2 database up to date as a whole. H2 ends each change of a table on its
 * own: a process that is killed between two of them, or finds the disk full, would leave tables
 * that no release knows. So they are changed in a copy, which takes the file's place when all is
 * done.
 */
final class H2Migration {
  private static final String ENDING = ".mv.db";

  private H2Migration() {}

  /**
   * @param url of a file that this process alone writes
   * @param source of connections to it; one is kept while it is copied and migrated, so that no
   *     other process opens it
   * @param migration brings what is at the URL that it is told up to date, and closes that
   * @return what is to be done when the file is closed: the copy takes its place
   * @throws UncheckedIOException the copy cannot be written
   */
  static Replacement migrateCopy(String url, DataSource source, Consumer<String> migration) {
    try {
      return Jdbi.create(source).withHandle(h -> migrateCopy(h, url, migration));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Replacement migrateCopy(Handle h, String url, Consumer<String> migration)
      throws IOException {
    String file = h.createQuery("select database_path()").mapTo(String.class).one();
    Path zip = Path.of(file + ".migrating.zip");
    Path copy = Path.of(file + ".migrating" + ENDING);
    try {
      Files.deleteIfExists(copy); // of a process that was killed
      h.execute("backup to ?", zip.toString());
      unpack(zip, copy);
      migration.accept(copyUrl(url, file));
      force(copy);
    } catch (IOException | RuntimeException e) {
      Files.deleteIfExists(copy);
      throw e;
    } finally {
      Files.deleteIfExists(zip);
    }
    return new Replacement(copy, Path.of(file + ENDING));
  }

  /** Closes the file, also where its URL says that it stays open. */
  static void shutDown(DataSource source) {
    try (Connection connection = source.getConnection();
        Statement statement = connection.createStatement()) {
      statement.execute("shutdown");
    } catch (SQLException e) {
      if (e.getErrorCode() != ErrorCode.DATABASE_CALLED_AT_SHUTDOWN) { // for the answer it is late
        throw new ConnectionException(e);
      }
    }
  }

  /** A copy that is to take a file's place. */
  record Replacement(Path copy, Path file) {
    void carryOut() {
      try {
        Files.move(copy, file, StandardCopyOption.ATOMIC_MOVE);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  private static String copyUrl(String url, String file) {
    int settings = url.indexOf(';');
    return H2Url.ofFile(Path.of(file + ".migrating"))
        + (settings < 0 ? "" : url.substring(settings));
  }

  private static void unpack(Path zip, Path copy) throws IOException {
    try (ZipInputStream in = new ZipInputStream(Files.newInputStream(zip))) {
      for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
        if (entry.getName().endsWith(ENDING)) {
          Files.copy(in, copy);
          return;
        }
      }
    }
    throw new IOException("The copy " + zip + " of the database is empty.");
  }

  private static void force(Path copy) throws IOException {
    try (FileChannel file = FileChannel.open(copy, StandardOpenOption.WRITE)) {
      file.force(true);
    }
  }
}
