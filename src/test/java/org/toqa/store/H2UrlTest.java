package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class H2UrlTest {
  @Test
  void aFileLosesNoCommittedRow() {
    assertEquals(
        "jdbc:h2:file:/data/toqa;CASE_INSENSITIVE_IDENTIFIERS=TRUE;DATABASE_TO_LOWER=TRUE"
            + ";DB_CLOSE_ON_EXIT=FALSE;MODE=MySQL;RETENTION_TIME=5000;TRACE_LEVEL_FILE=0"
            + ";WRITE_DELAY=0",
        H2Url.withSettings(H2Url.ofFile(Path.of("/data/toqa"))));
  }

  @Test
  void whatTheUrlSaysItselfStays() {
    assertEquals(
        "jdbc:h2:./x;mode=MySQL;write_delay=500;CASE_INSENSITIVE_IDENTIFIERS=TRUE"
            + ";DATABASE_TO_LOWER=TRUE;DB_CLOSE_ON_EXIT=FALSE;RETENTION_TIME=5000;TRACE_LEVEL_FILE=0",
        H2Url.withSettings("jdbc:h2:./x;mode=MySQL;write_delay=500"));
  }

  @ParameterizedTest
  @CsvSource({
    "jdbc:h2:file:/data/toqa, true",
    "jdbc:h2:./toqa, true",
    "jdbc:h2:~/toqa, true",
    "jdbc:h2:C:/toqa, true",
    "jdbc:h2:mem:toqa, false",
    "jdbc:h2:tcp://elsewhere/toqa, false",
    "jdbc:h2:ssl://elsewhere/toqa, false",
    "jdbc:mysql://elsewhere/toqa, false"
  })
  void onlyAFileOfThisProcessIsItsOwn(String url, boolean isOwn) {
    assertEquals(isOwn, H2Url.isOwnFile(url));
  }
}
