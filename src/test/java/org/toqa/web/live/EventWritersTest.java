package org.toqa.web.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.BiPredicate;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.Site;

class EventWritersTest {
  private static final Site MAIN = new Site(Site.FIRST_ID, "main");
  private static final Site NORTH = new Site(Site.FIRST_ID + 1, "north");

  @Test
  void thoseOfFloorsAndSitesThatAreGoneAreForgotten() {
    Set<Site> sites = new HashSet<>(List.of(MAIN, NORTH));
    Set<String> floors = new HashSet<>(List.of("hall", "cellar"));
    BiPredicate<Site, @Nullable String> isThere =
        (site, floor) -> sites.contains(site) && (floor == null || floors.contains(floor));
    EventWriters writers = new EventWriters();
    SnapshotEventWriter kept = writers.writer(MAIN, Locale.ENGLISH, "hall", isThere);
    writers.writer(MAIN, Locale.ENGLISH, "cellar", isThere);
    writers.writer(NORTH, Locale.ENGLISH, null, isThere);
    assertEquals(3, writers.size());

    floors.remove("cellar");
    sites.remove(NORTH);
    writers.writer(MAIN, Locale.ENGLISH, null, isThere);

    assertEquals(2, writers.size());
    assertSame(kept, writers.writer(MAIN, Locale.ENGLISH, "hall", isThere));
  }
}
