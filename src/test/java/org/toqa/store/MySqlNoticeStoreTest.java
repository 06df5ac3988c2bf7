package org.toqa.store;

import java.sql.SQLException;
import org.junit.jupiter.api.Tag;

/** The same on a real MySQL. */
@Tag("full")
class MySqlNoticeStoreTest extends NoticeStoreTest {
  @Override
  Database open() throws SQLException {
    return EmptyMySql.open();
  }
}
