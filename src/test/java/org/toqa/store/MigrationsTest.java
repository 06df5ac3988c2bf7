package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.LocalDateTime;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import org.flywaydb.core.Flyway;
import org.flywaydb.core.api.configuration.FluentConfiguration;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.testbed.RealMySql;

/** The shipped {@code sql/}, on the databases that the product runs on. */
class MigrationsTest {
  private static final Set<String> TABLES =
      Set.of(
          "users", "sessions", "robots", "tasks", "task_robots", "drives", "events", "robot_use");

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

  @Test
  void theHistoryTellsOnH2WhenOldTasksWereGivenAndDelivered() throws SQLException {
    assertOldTasksAreTimed(
        "jdbc:h2:mem:old-tasks;MODE=MySQL;DATABASE_TO_LOWER=TRUE"
            + ";CASE_INSENSITIVE_IDENTIFIERS=TRUE;DB_CLOSE_DELAY=-1");
  }

  @Test
  @Tag("full")
  void theHistoryTellsOnMySqlWhenOldTasksWereGivenAndDelivered() throws SQLException {
    assertOldTasksAreTimed(RealMySql.newDatabase());
  }

  /** A task that was given twice and delivered, and one that was given and brought back. */
  private static void assertOldTasksAreTimed(String url) throws SQLException {
    flyway(url).target("8").load().migrate();
    try (Connection connection = DriverManager.getConnection(url);
        Statement statement = connection.createStatement()) {
      for (String task : new String[] {"1, 'DONE'", "2, 'CANCELLED'"}) {
        statement.execute(
            """
            insert into tasks (id, state, name, user_name, floor, load_kg, start_x, start_y, goal_x,
              goal_y, priority, created_at, changed_at)
            values (%s, 'box', 'Ann', 'lab', 1, 0, 0, 1, 1, 0, '2026-11-21 08:00:00',
              '2026-11-21 09:00:00')
            """
                .formatted(task));
      }
      for (String event :
          new String[] {
            "1, '2026-11-21 08:01:00', 'task.assigned'",
            "1, '2026-11-21 08:02:00', 'task.assigned'",
            "1, '2026-11-21 08:30:00', 'task.delivered'",
            "1, '2026-11-21 08:31:00', 'task.delivered'", // the second of its robots
            "2, '2026-11-21 08:03:00', 'task.assigned'",
            "2, '2026-11-21 08:40:00', 'task.delivered'"
          }) {
        statement.execute(
            "insert into events (task_id, at, kind, who, text) values (%s, 'toqa', 'so it was')"
                .formatted(event));
      }
      flyway(url).load().migrate();

      try (ResultSet tasks =
          statement.executeQuery("select assigned_at, delivered_at from tasks order by id")) {
        tasks.next();
        assertEquals(at("08:01"), tasks.getObject(1, LocalDateTime.class));
        assertEquals(at("08:31"), tasks.getObject(2, LocalDateTime.class));
        tasks.next();
        assertEquals(at("08:03"), tasks.getObject(1, LocalDateTime.class));
        assertNull(tasks.getObject(2, LocalDateTime.class));
      }
    }
  }

  private static LocalDateTime at(String time) {
    return LocalDateTime.parse("2026-11-21T" + time);
  }

  private static FluentConfiguration flyway(String url) {
    return Flyway.configure().dataSource(url, null, null).locations("classpath:sql");
  }

  private static void assertMigrates(String url) throws SQLException {
    Flyway flyway = flyway(url).load();

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
