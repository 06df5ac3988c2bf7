package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import org.flywaydb.core.Flyway;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.testbed.RealMySql;

/** The shipped {@code sql/}, on the databases that the product runs on. */
class MigrationsTest {
  private static final Set<String> TABLES =
      Set.of("users", "sessions", "robots", "tasks", "task_robots", "drives", "events");

  @Test
  void runOnH2() throws SQLException {
    assertMigrates(
        "jdbc:h2:mem:migrations;MODE=MySQL;DATABASE_TO_LOWER=TRUE"
            + ";CASE_INSENSITIVE_IDENTIFIERS=TRUE;DB_CLOSE_DELAY=-1");
  }

  @Test
  @Tag("full")
  void runOnMySql() throws SQLException {
    assertMigrates(RealMySql.newDatabase());
  }

  private static void assertMigrates(String url) throws SQLException {
    Flyway flyway =
        Flyway.configure().dataSource(url, null, null).locations("classpath:sql").load();

    assertTrue(flyway.migrate().migrationsExecuted > 0);
    assertEquals(0, flyway.migrate().migrationsExecuted);
    assertTrue(tables(url).containsAll(TABLES), tables(url)::toString);
  }

  private static Set<String> tables(String url) throws SQLException {
    Set<String> names = new TreeSet<>();
    try (Connection connection = DriverManager.getConnection(url);
        ResultSet tables =
            connection
                .getMetaData()
                .getTables(connection.getCatalog(), null, "%", new String[] {"TABLE"})) {
      while (tables.next()) {
        names.add(tables.getString("TABLE_NAME").toLowerCase(Locale.ROOT));
      }
    }
    return names;
  }
}
