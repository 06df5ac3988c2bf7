package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.sql.SQLTransientConnectionException;
import java.time.Instant;
import java.util.List;
import java.util.Queue;
import java.util.UUID;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.persistence.StoreException;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.testbed.LabTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

@Timeout(60)
class StoreWriterTest {
  private static final long GUARD_SECONDS = 20;
  private static final Instant AT = Instant.parse("2026-11-21T10:00:00Z");

  private final Database database = MemoryDatabase.open("writer-" + System.nanoTime());
  private final JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
  private final Queue<Sentence> leftOut = new ConcurrentLinkedQueue<>();
  private final StoreWriter writer = new StoreWriter("test", FleetRuntime.USUAL, leftOut::add);
  private final CountDownLatch stored = new CountDownLatch(1);

  @AfterEach
  void close() {
    writer.close();
    database.close();
  }

  @Test
  void whatCanNeverBeStoredStopsNothingBehindIt() throws Exception {
    writer.write(() -> add("a name too long for its column ".repeat(10)), () -> {});
    writer.write(() -> add("crate"), stored::countDown);

    assertTrue(stored.await(GUARD_SECONDS, TimeUnit.SECONDS));
    assertEquals(1, store.openTasks().size());
    assertEquals(List.of(Phrase.CHANGE_LEFT_OUT), leftOut.stream().map(Sentence::phrase).toList());
  }

  @Test
  void aFaultOfTheServerItselfStopsNothingBehindIt() throws Exception {
    writer.write(
        () -> {
          throw new IllegalStateException("said by the test");
        },
        () -> {});
    writer.write(() -> add("crate"), stored::countDown);

    assertTrue(stored.await(GUARD_SECONDS, TimeUnit.SECONDS));
  }

  @Test
  void anOutageIsTriedAgainAndAllOthersWait() throws Exception {
    AtomicInteger tries = new AtomicInteger();
    writer.write(
        () -> {
          if (tries.incrementAndGet() < 3) {
            throw new StoreException("away", new SQLTransientConnectionException("no connection"));
          }
          add("first");
        },
        () -> {});
    writer.write(() -> add("second"), stored::countDown);

    assertTrue(stored.await(GUARD_SECONDS, TimeUnit.SECONDS));
    assertEquals(
        List.of("first", "second"),
        store.openTasks().stream().map(task -> task.mission().task().name()).toList());
  }

  private void add(String name) {
    store.addTasks(List.of(new Submission(LabTask.of(name, "ann", AT), UUID.randomUUID())));
  }
}
