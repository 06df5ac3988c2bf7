package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.TimeZone;
import org.junit.jupiter.api.Test;

/** How values are kept in columns. */
class DatabaseTypesTest {
  @Test
  void momentsAreStoredInUtcWhereverTheProcessRuns() throws Exception {
    TimeZone before = TimeZone.getDefault();
    TimeZone.setDefault(TimeZone.getTimeZone("America/Bogota"));
    try (Database database = MemoryDatabase.open("database-types-" + System.nanoTime())) {
      String stored =
          database
              .jdbi()
              .withHandle(
                  h ->
                      h.createQuery("select cast(:at as varchar)")
                          .bind("at", Instant.parse("2026-11-21T10:00:00.123Z"))
                          .mapTo(String.class)
                          .one());
      assertEquals("2026-11-21 10:00:00.123", stored);
    } finally {
      TimeZone.setDefault(before);
    }
  }
}
