package org.toqa.store;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.h2.mvstore.MVStoreException;
import org.h2.mvstore.MVStoreTool;
import org.jdbi.v3.core.Handle;

/**
 * What a database takes, and what of that is needed.
 *
 * @param bytes of its files; those of a MySQL server's tables, without its logs
 * @param contentBytes of a compacted copy; with MySQL, of the pages that are in use
 */
public record DatabaseSize(long bytes, long contentBytes) {

  /**
   * Measures the file of an H2 database, which may be in use: a copy of it is as good as what a
   * killed process leaves.
   *
   * @param file its name ends with {@code .mv.db}
   * @throws IOException it cannot be read or copied, or is not such a file
   */
  static DatabaseSize ofH2File(Path file) throws IOException {
    Path folder = Files.createTempDirectory("toqa-size");
    Path copy = folder.resolve("copy.mv.db");
    try {
      Files.copy(file, copy);
      long bytes = Files.size(copy);
      MVStoreTool.compact(copy.toString(), false);
      return new DatabaseSize(bytes, Files.size(copy));
    } catch (MVStoreException e) {
      throw new IOException(file + " is no database of H2: " + e.getMessage(), e);
    } finally {
      MVStoreTool.compactCleanUp(copy.toString());
      Files.deleteIfExists(copy);
      Files.delete(folder);
    }
  }

  /** Measures the tables of the MySQL database that a connection uses. */
  static DatabaseSize ofMySql(Handle h) {
    List<String> tables =
        h.createQuery(
                "select table_name from information_schema.tables where table_schema = database()")
            .mapTo(String.class)
            .list();
    if (!tables.isEmpty()) { // else the figures are old
      h.execute("analyze no_write_to_binlog table " + String.join(", ", tables));
      h.execute("set session information_schema_stats_expiry = 0");
    }
    return h.createQuery(
            """
            select coalesce(sum(data_length + index_length + data_free), 0) as bytes,
                   coalesce(sum(data_length + index_length), 0) as content
            from information_schema.tables
            where table_schema = database()
            """)
        .map((row, context) -> new DatabaseSize(row.getLong("bytes"), row.getLong("content")))
        .one();
  }
}
