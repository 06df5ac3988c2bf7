package org.toqa.store;

import java.sql.SQLException;
import org.junit.jupiter.api.Tag;
import org.toqa.testbed.RealMySql;

/** The same on a real MySQL. */
@Tag("full")
class MySqlTaskArchiveTest extends TaskArchiveTest {
  @Override
  Database open() throws SQLException {
    return Database.open(RealMySql.newDatabase(), "", "");
  }
}
