package org.toqa.store;

import java.sql.SQLException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** A new database for each test method, with its tables; H2 unless a subclass opens another. */
abstract class DatabaseTest {
  Database database;

  Database open() throws SQLException {
    return MemoryDatabase.open("store-" + System.nanoTime());
  }

  @BeforeEach
  void openDatabase() throws SQLException {
    database = open();
  }

  @AfterEach
  void closeDatabase() {
    database.close();
  }
}
