package org.toqa.store;

import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/**
 * H2 databases in memory with the shipped tables. They are migrated once in a process, and the
 * others are copies of that one: a migration takes longer than most tests.
 */
public final class MemoryDatabase {
  private static final String USER = "toqa";

  /** What makes an empty database as the migrated one is. */
  private static final List<String> STATEMENTS = migrated();

  private MemoryDatabase() {}

  /**
   * @param name of its own in the process
   */
  public static Database open(String name) {
    return open(name, Database.READ_LIMIT);
  }

  /** The same, where a statement of a reader may take so long. */
  static Database open(String name, Duration readLimit) {
    String url = H2Url.withSettings(url(name));
    try (Connection connection = DriverManager.getConnection(url, USER, "");
        Statement statement = connection.createStatement()) {
      for (String sql : STATEMENTS) {
        statement.execute(sql);
      }
    } catch (SQLException e) {
      throw new IllegalStateException(e);
    }
    return new Database(url, USER, "", readLimit);
  }

  static String url(String name) {
    return "jdbc:h2:mem:" + name + ";DB_CLOSE_DELAY=-1";
  }

  private static List<String> migrated() {
    try (Database database = Database.open(url("migrated"), USER, "")) {
      return script(database);
    } catch (SQLException e) {
      throw new IllegalStateException(e);
    }
  }

  /** All that a database is made of, a statement each. */
  static List<String> script(Database database) throws SQLException {
    List<String> statements = new ArrayList<>();
    try (Connection connection = database.jdbi().open().getConnection();
        Statement statement = connection.createStatement();
        ResultSet lines = statement.executeQuery("script")) {
      while (lines.next()) {
        statements.add(lines.getString(1));
      }
    }
    return statements;
  }
}
