package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class MemoryDatabaseTest {
  @Test
  void copyEqualsWhatTheMigrationsMake() throws Exception {
    try (Database copy = MemoryDatabase.open("copy");
        Database migrated = Database.open(MemoryDatabase.url("migrated-anew"), "toqa", "")) {
      List<String> made = MemoryDatabase.script(migrated);
      assertTrue(made.size() > 50, made::toString);

      assertEquals(withoutTimes(made), withoutTimes(MemoryDatabase.script(copy)));
    }
  }

  /**
   * Without when it was migrated and how long that took; sorted, since H2 names constraints in the
   * order of ids that it gives anew.
   */
  private static List<String> withoutTimes(List<String> statements) {
    return statements.stream()
        .map(s -> s.replaceAll("TIMESTAMP '[^']+', \\d+, TRUE", "TIMESTAMP, TIME, TRUE"))
        .map(s -> s.replaceAll("SALT '[^']*' HASH '[^']*'", "SALT, HASH"))
        .sorted()
        .toList();
  }
}
