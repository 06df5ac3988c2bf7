package org.toqa.store;

import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.testbed.RealMySql;

/**
 * One database of this process on a real MySQL, which is migrated once and emptied for each test: a
 * migration takes longer than most tests.
 */
final class EmptyMySql {
  private static @Nullable String url;

  private EmptyMySql() {}

  /** As new; whoever had it before has closed it. */
  static synchronized Database open() throws SQLException {
    if (url == null) {
      String created = RealMySql.newDatabase();
      Database.open(created, "", "").close();
      url = created;
    }
    empty(url);
    return new Database(url, "", "", Database.READ_LIMIT);
  }

  /** No row is left, and ids begin with 1. */
  private static void empty(String url) throws SQLException {
    try (Connection connection = DriverManager.getConnection(url);
        Statement statement = connection.createStatement()) {
      statement.execute("set foreign_key_checks = 0");
      for (String table : tables(statement)) {
        statement.execute("truncate table " + table);
      }
    }
  }

  private static List<String> tables(Statement statement) throws SQLException {
    List<String> tables = new ArrayList<>();
    try (ResultSet rows =
        statement.executeQuery(
            "select table_name from information_schema.tables where table_schema = database()"
                + " and table_type = 'BASE TABLE' and table_name <> 'flyway_schema_history'")) {
      while (rows.next()) {
        tables.add(rows.getString(1));
      }
    }
    return tables;
  }
}
