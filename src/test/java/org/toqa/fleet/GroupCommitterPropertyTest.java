package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.lifecycle.AfterProperty;
import org.jspecify.annotations.Nullable;
import org.toqa.persistence.StoreException;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.testbed.LogLevel;
import org.toqa.testbed.Tally;

/**
 * Writers with changes that are stored, refused, or fail for a while, over a store that is away now
 * and then, also when it has stored what it was given. Each is told what became of its change,
 * once, and then that is so; of one writer's changes none overtakes another.
 */
class GroupCommitterPropertyTest {
  private static final int MOST_WRITERS = 6;
  private static final int MOST_CHANGES = 30;
  private static final long GUARD_SECONDS = 60;

  /** What a call that returns nothing may return. */
  private static final Object NOTHING = new Object();

  private final LogLevel log = LogLevel.off("org.toqa.fleet.GroupCommitter");
  private final Database database = MemoryDatabase.open("groups-" + System.nanoTime());
  private long outages;
  private long refusals;

  @AfterProperty
  void close() {
    database.close();
    log.close();
    Tally.add("outages of the store", outages);
    assertTrue(outages > 100 && refusals > 100, outages + " outages, " + refusals + " refusals");
  }

  @Property(tries = 100)
  void whatIsToldIsSo(@ForAll long seed) throws Exception {
    Run run = new Run(new Random(seed));
    run.write();
    run.check();
    outages += run.outages;
    refusals += run.refused.size();
  }

  /** All that is shared is guarded by this. */
  private final class Run {
    private final Random random;
    private final LinkedHashSet<String> disk = new LinkedHashSet<>();
    private @Nullable List<String> transaction;
    private final Map<String, List<String>> written = new HashMap<>();
    private final Map<String, List<String>> told = new HashMap<>();
    private final List<String> refused = new ArrayList<>();
    private final List<String> wrong = new ArrayList<>();
    private final List<CountDownLatch> open = new ArrayList<>();
    private long outages;

    Run(Random random) {
      this.random = random;
    }

    void write() throws InterruptedException {
      FleetStore store =
          TamperedStore.of(
              new JdbiFleetStore(database.jdbi()),
              (method, arguments, real) ->
                  switch (method) {
                    case "saveTogether" -> saveTogether((Runnable) arguments[0]);
                    case "checkAvailable" -> checkAvailable();
                    default -> real.go();
                  });
      GroupCommitter committer =
          new GroupCommitter("test", store, FleetRuntime.USUAL, change -> {}, Duration.ofMillis(1));
      int writers = 1 + random.nextInt(MOST_WRITERS);
      int changes = random.nextInt(MOST_CHANGES);
      for (int i = 0; i < changes; i++) {
        String writer = "w" + random.nextInt(writers);
        writeOne(committer.writer(writer), writer, writer + " " + i);
      }
      for (CountDownLatch settled : open) {
        assertTrue(settled.await(GUARD_SECONDS, TimeUnit.SECONDS), "not all are told");
      }
      committer.close();
    }

    private synchronized void writeOne(StoreWriter writer, String name, String label) {
      CountDownLatch settled = new CountDownLatch(1);
      open.add(settled);
      boolean isRefused = random.nextInt(8) == 0;
      int[] failures = {random.nextInt(8) == 0 ? 1 + random.nextInt(3) : 0};
      boolean isTriedOnce = random.nextInt(8) == 0;
      if (!isRefused && !(isTriedOnce && failures[0] > 0)) {
        written.computeIfAbsent(name, _ -> new ArrayList<>()).add(label);
      }
      Runnable change =
          () -> {
            if (isRefused) {
              throw new StoreException(StoreException.Kind.REFUSED, "too long", null);
            }
            if (failures[0] > 0) {
              failures[0]--;
              throw new StoreException("locked", null);
            }
            save(label, isTriedOnce);
          };
      Runnable stored =
          () -> {
            recordStored(name, label);
            settled.countDown();
          };
      if (isTriedOnce) {
        writer.tryOnce(
            change,
            stored,
            why -> {
              recordFailed(label, isRefused || "locked".equals(why.getMessage()));
              settled.countDown();
            });
      } else {
        writer.write(
            change,
            stored,
            why -> {
              recordFailed(label, isRefused && why.isRefusal());
              settled.countDown();
            });
      }
    }

    private synchronized void recordStored(String name, String label) {
      if (!disk.contains(label)) {
        wrong.add(label + " was told to be stored and is not");
      }
      told.computeIfAbsent(name, _ -> new ArrayList<>()).add(label);
    }

    private synchronized void recordFailed(String label, boolean isRightly) {
      if (!isRightly || disk.contains(label)) {
        wrong.add(label + " was told to be refused");
      }
      refused.add(label);
    }

    private synchronized void save(String label, boolean isTriedOnce) {
      if (transaction != null) {
        transaction.add(label);
        return;
      }
      int fate = isTriedOnce ? 2 : random.nextInt(8);
      if (fate != 0) {
        disk.add(label);
      }
      if (fate < 2) {
        throw away();
      }
    }

    private synchronized Object saveTogether(Runnable changes) {
      int fate = random.nextInt(8);
      if (fate == 0) {
        throw away();
      }
      transaction = new ArrayList<>();
      try {
        changes.run();
        if (fate == 1) {
          throw away();
        }
        disk.addAll(transaction); // what is stored twice is stored once
        if (fate == 2) {
          throw away();
        }
      } finally {
        transaction = null;
      }
      return NOTHING;
    }

    private synchronized Object checkAvailable() {
      if (random.nextInt(4) == 0) {
        throw away();
      }
      return NOTHING;
    }

    private StoreException away() {
      outages++;
      return new StoreException("away", null);
    }

    synchronized void check() {
      assertEquals(List.of(), wrong);
      assertEquals(written, told);
      for (Map.Entry<String, List<String>> writer : written.entrySet()) {
        assertEquals(
            writer.getValue(),
            disk.stream().filter(label -> label.startsWith(writer.getKey() + " ")).toList());
      }
      refused.forEach(label -> assertTrue(!disk.contains(label), label));
      assertEquals(open.size(), refused.size() + told.values().stream().mapToInt(List::size).sum());
    }
  }
}
