package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;
import java.util.stream.Stream;
import org.flywaydb.core.Flyway;
import org.flywaydb.core.api.FlywayException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The file of an older release is brought up to date as a whole, or stays as it was. */
class H2MigrationTest {
  private static final String OLD_VERSION = "60";

  @TempDir private Path folder;
  private String url = "";

  @BeforeEach
  void makeOldFile() {
    url = H2Url.withSettings(H2Url.ofFile(folder.resolve("toqa")));
    Flyway.configure()
        .dataSource(url, "toqa", "secret")
        .locations("classpath:sql")
        .target(OLD_VERSION)
        .load()
        .migrate();
  }

  @Test
  void aMigrationThatFailsLeavesTheFileAsItWas() throws Exception {
    execute(
        "insert into users (name, name_key, password_hash, role, created_at) values ('Ann', 'ann', 'x', 'CLERK', '2026-01-01')");
    execute("create table explorations (a_table_that int)"); // a later release makes one so called
    assertThrows(FlywayException.class, this::open);

    assertEquals(
        OLD_VERSION, text("select max(cast(\"version\" as int)) from \"flyway_schema_history\""));
    assertEquals(List.of("toqa.mv.db"), files());

    execute("drop table explorations");
    open();
    assertEquals("Ann", text("select name from users"));
    assertTrue(
        text("select max(cast(\"version\" as int)) from \"flyway_schema_history\"")
                .compareTo(OLD_VERSION)
            > 0);
    assertEquals(List.of("toqa.mv.db"), files());
  }

  @Test
  void whatAKilledProcessLeftOfItsCopyIsNotTaken() throws Exception {
    Files.writeString(folder.resolve("toqa.migrating.mv.db"), "half of a copy");
    Files.writeString(folder.resolve("toqa.migrating.zip"), "half of a copy");
    open();
    assertEquals(List.of("toqa.mv.db"), files());
  }

  @ParameterizedTest
  @ValueSource(strings = {";DB_CLOSE_DELAY=-1", ";IFEXISTS=TRUE"})
  void settingsOfTheUrlHoldForTheCopyToo(String settings) throws Exception {
    url += settings;
    open();
    execute(
        "insert into users (name, name_key, password_hash, role, created_at) values ('Ann', 'ann', 'x', 'CLERK', '2026-01-01')");
    execute("shutdown"); // it was to stay open
    assertEquals("Ann", text("select name from users"));
  }

  private void open() {
    Database.open(url, "toqa", "secret").close();
  }

  private void execute(String sql) throws SQLException {
    try (Connection connection = DriverManager.getConnection(url, "toqa", "secret");
        Statement statement = connection.createStatement()) {
      statement.execute(sql);
    }
  }

  private String text(String sql) throws SQLException {
    try (Connection connection = DriverManager.getConnection(url, "toqa", "secret");
        Statement statement = connection.createStatement();
        ResultSet row = statement.executeQuery(sql)) {
      assertTrue(row.next());
      return row.getString(1);
    }
  }

  private List<String> files() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }
}
