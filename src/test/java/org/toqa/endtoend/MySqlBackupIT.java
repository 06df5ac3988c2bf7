package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.Needed;
import org.toqa.testbed.OwnMySql;

/** A server on MySQL is put back to a dump, as docs/operations.md says. */
@Tag("full")
class MySqlBackupIT {
  private static final String CLIENT =
      Path.of("src/test/services/mysql-client.sh").toAbsolutePath().toString();

  @TempDir private Path folder;

  @Test
  void aDumpThatIsTakenWhileRobotsCarryHoldsAll() throws Exception {
    Needed.orLeftOut(
        System.getenv("TOQA_TEST_MYSQL_URL") == null,
        "a MySQL of its own: run ./toqa test without TOQA_TEST_MYSQL_URL");
    Path key = folder.resolve("data/link.p12");
    Path keptKey = folder.resolve("toqa.link.p12");
    Path dump = folder.resolve("toqa.sql");
    try (OwnMySql mySql = new OwnMySql(folder)) {
      Needed.orLeftOut(
          !mySql.isMariaDb(),
          "MySQL, for MariaDB dumps otherwise: ./toqa test fetches it on Debian");
      addUser(mySql);
      try (RunningServer server =
          new RunningServer(
              folder, "--config", config(mySql), "--simulate", "1", "--speed", "20")) {
        BackupScenario work = BackupScenario.start(server);
        client(
            mySql,
            dump,
            "mysqldump",
            "--single-transaction",
            "--no-tablespaces",
            "--set-gtid-purged=OFF",
            "toqa");
        Files.copy(key, keptKey);
        work.workAfterBackup();
        server.stop();

        execute(mySql, "drop database toqa", "create database toqa");
        client(mySql, dump, "mysql", "toqa");
        Files.delete(key);
        Files.copy(keptKey, key);
        server.start();

        work.assertRestoredAndContinues();
      }
    }
  }

  /** As operators make it: it may do everything with its own database and nothing else. */
  private static void addUser(OwnMySql mySql) throws Exception {
    execute(
        mySql, "create user toqa identified by 'secret-of-toqa'", "grant all on toqa.* to toqa");
  }

  private static void execute(OwnMySql mySql, String... statements) throws Exception {
    try (Connection connection = DriverManager.getConnection(mySql.url());
        Statement statement = connection.createStatement()) {
      for (String sql : statements) {
        statement.execute(sql);
      }
    }
  }

  private String config(OwnMySql mySql) throws Exception {
    String yaml =
        """
        database:
          url: "jdbc:mysql://127.0.0.1:%d/toqa"
          user: toqa
          password: secret-of-toqa
        """
            .formatted(mySql.port());
    return Files.writeString(folder.resolve("server.yaml"), yaml).toString();
  }

  /** Runs a program of MySQL as that user; a dump is written to the file, else the file is read. */
  private static void client(OwnMySql mySql, Path file, String program, String... arguments)
      throws Exception {
    List<String> command =
        new ArrayList<>(
            List.of(CLIENT, program, "-h", "127.0.0.1", "-P", "" + mySql.port(), "-u", "toqa"));
    command.addAll(List.of(arguments));
    ProcessBuilder process = new ProcessBuilder(command);
    process.environment().put("MYSQL_PWD", "secret-of-toqa");
    process.redirectError(ProcessBuilder.Redirect.INHERIT);
    if (program.equals("mysql")) {
      process.redirectInput(file.toFile());
    } else {
      process.redirectOutput(file.toFile());
    }
    assertEquals(0, process.start().waitFor(), program);
  }
}
