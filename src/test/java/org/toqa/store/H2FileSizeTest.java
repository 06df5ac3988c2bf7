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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class H2FileSizeTest {
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
      H2FileSize inUse = H2FileSize.of(file);

      assertEquals(Files.size(file), inUse.bytes());
      assertTrue(inUse.bytes() > 5 * inUse.contentBytes(), inUse::toString);
      assertTrue(inUse.contentBytes() > 10_000 * 6, inUse::toString);
    }
  }

  @Test
  void anotherFileIsRefused() throws Exception {
    Path file = Files.writeString(folder.resolve("toqa.mv.db"), "since " + Instant.EPOCH);

    assertThrows(IOException.class, () -> H2FileSize.of(file));
  }
}
