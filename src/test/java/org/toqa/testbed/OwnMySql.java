package org.toqa.testbed;

import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.time.Duration;
import java.util.concurrent.TimeUnit;

/**
 * A MySQL server for one test, which may stop, kill and start it. For tests tagged {@code full}.
 */
public final class OwnMySql implements AutoCloseable {
  private static final Duration LIMIT = Duration.ofMinutes(2);

  private final Path folder;
  private int port;
  private Process server;

  /**
   * MySQL binds no port of its own choice: it is given a free one, and another where somebody else
   * was faster.
   *
   * @param folder holds the data, and the server's log
   */
  public OwnMySql(Path folder) throws Exception {
    this.folder = folder;
    for (int tries = 5; tries > 0; tries--) {
      port = freePort();
      server = launch();
      if (answers()) {
        return;
      }
    }
    throw new AssertionError("MySQL does not start: " + log());
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  private Process launch() throws IOException {
    File log = folder.resolve("mysql.log").toFile();
    return new ProcessBuilder(
            Path.of("src/test/services/own-database.sh").toAbsolutePath().toString(),
            folder.resolve("mysql").toString(),
            String.valueOf(port))
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.appendTo(log))
        .start();
  }

  /** Of a database that is made when it is first used. */
  public String url() {
    return "jdbc:mysql://127.0.0.1:" + port + "/toqa?user=root&createDatabaseIfNotExist=true";
  }

  public int port() {
    return port;
  }

  /** Where no MySQL can be had. */
  public boolean isMariaDb() throws SQLException {
    try (Connection connection = DriverManager.getConnection(url())) {
      return connection.getMetaData().getDatabaseProductVersion().contains("MariaDB");
    }
  }

  /** It keeps its connections, and says nothing. */
  public void freeze() throws Exception {
    signal("-STOP");
  }

  public void thaw() throws Exception {
    signal("-CONT");
  }

  /** As {@code kill -9} does it. */
  public void kill() {
    server.destroyForcibly().onExit().join();
  }

  public void startAgain() throws IOException {
    server = launch();
  }

  private void signal(String signal) throws Exception {
    Process kill = new ProcessBuilder("kill", signal, String.valueOf(server.pid())).start();
    if (kill.waitFor() != 0) {
      throw new AssertionError("kill " + signal + " failed");
    }
  }

  /** False where the port was taken; an {@link AssertionError} where it does not start at all. */
  private boolean answers() throws Exception {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (server.isAlive() && System.nanoTime() < end) {
      try (Connection connection = DriverManager.getConnection(url())) {
        if (connection.isValid(5) && server.isAlive()) {
          return true;
        }
      } catch (SQLException e) {
        TimeUnit.MILLISECONDS.sleep(200); // it is not up yet
      }
    }
    close();
    if (log().contains("Address already in use")) {
      return false;
    }
    throw new AssertionError("MySQL does not start: " + log());
  }

  private String log() throws IOException {
    return Files.readString(folder.resolve("mysql.log"));
  }

  @Override
  public void close() {
    kill();
  }
}
