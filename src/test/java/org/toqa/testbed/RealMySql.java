package org.toqa.testbed;

import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.concurrent.atomic.AtomicInteger;

/** The MySQL server that {@code ./toqa test} has started. For tests with the tag {@code full}. */
public final class RealMySql {
  private static final String PROPERTY = "toqa.mysql.url";
  private static final AtomicInteger COUNT = new AtomicInteger();

  private RealMySql() {}

  /** The URL of a new, empty database. */
  public static String newDatabase() throws SQLException {
    String server = System.getProperty(PROPERTY);
    if (server == null) {
      throw new AssertionError("-D" + PROPERTY + " is not set: run ./toqa test");
    }
    String name = "toqa_" + ProcessHandle.current().pid() + "_" + COUNT.incrementAndGet();
    try (Connection connection = DriverManager.getConnection(server);
        Statement statement = connection.createStatement()) {
      statement.execute("create database " + name);
    }
    int parameters = server.indexOf('?');
    return parameters < 0
        ? server + name
        : server.substring(0, parameters) + name + server.substring(parameters);
  }
}
