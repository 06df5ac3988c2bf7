package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.stream.IntStream;
import org.h2.mvstore.MVMap;
import org.h2.mvstore.MVStore;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.RealMySql;

class DatabaseSizeTest {
  @TempDir private Path folder;

  @Test
  void whatWasOverwrittenIsNoContent() throws Exception {
    Path file = folder.resolve("toqa.mv.db");
    List<String> rows = IntStream.range(0, 10_000).mapToObj(i -> "row " + i).toList();
    try (MVStore store = MVStore.open(file.toString())) {
      store.setRetentionTime(1_000_000);
      MVMap<Integer, String> map = store.openMap("rows");
      for (int round = 0; round < 20; round++) {
        for (int i = 0; i < rows.size(); i++) {
          map.put(i, rows.get(i) + " " + round);
        }
        store.commit();
      }
      DatabaseSize inUse = DatabaseSize.ofH2File(file);

      assertEquals(Files.size(file), inUse.bytes());
      assertTrue(inUse.bytes() > 5 * inUse.contentBytes(), inUse::toString);
      assertTrue(inUse.contentBytes() > 10_000 * 6, inUse::toString);
    }
  }

  @Test
  void openDatabaseIsAtLeastItsContent() {
    try (Database database = Database.open(Database.fileUrl(folder.resolve("toqa")), "toqa", "")) {
      DatabaseSize size = database.size();

      assertTrue(size.bytes() >= size.contentBytes() && size.contentBytes() > 0, size::toString);
    }
  }

  @Test
  @Tag("full")
  void rowsOfMySqlAreCounted() throws Exception {
    try (Database database = Database.open(RealMySql.newDatabase(), "", "")) {
      long before = database.size().contentBytes();
      database
          .jdbi()
          .useHandle(
              h -> {
                h.execute("create table filler (content mediumtext)");
                h.execute("insert into filler values (repeat('x', 3000000))");
              });
      DatabaseSize size = database.size();

      assertTrue(size.contentBytes() >= before + 3_000_000, size::toString);
      assertTrue(size.bytes() >= size.contentBytes(), size::toString);
    }
  }

  @Test
  void databaseInMemoryHasNone() {
    try (Database database = MemoryDatabase.open("size")) {
      assertThrows(IllegalStateException.class, database::size);
    }
  }

  @Test
  void anotherFileIsRefused() throws Exception {
    Path file = Files.writeString(folder.resolve("toqa.mv.db"), "since " + Instant.EPOCH);

    assertThrows(IOException.class, () -> DatabaseSize.ofH2File(file));
  }
}
