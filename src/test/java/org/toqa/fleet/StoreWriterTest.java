package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.sql.SQLTransientConnectionException;
import java.time.Instant;
import java.util.List;
import java.util.Queue;
import java.util.UUID;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
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
  private final StoreWriter writer =
      new StoreWriter("test", FleetRuntime.USUAL, this::transaction, leftOut::add);
  private final CountDownLatch stored = new CountDownLatch(1);
  private final CountDownLatch goOn = new CountDownLatch(1);
  private final AtomicInteger transactions = new AtomicInteger();

  private void transaction(Runnable work) {
    transactions.incrementAndGet();
    store.inOneTransaction(work);
  }

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

  @Test
  void whatWaitsForTheWriterIsOneTransaction() throws Exception {
    holdBack();
    List<String> told = new CopyOnWriteArrayList<>();
    for (int i = 0; i < 50; i++) {
      String name = "crate " + i;
      writer.write(() -> add(name), () -> told.add(name));
    }
    writer.write(() -> {}, stored::countDown);
    int before = transactions.get();
    goOn.countDown();

    assertTrue(stored.await(GUARD_SECONDS, TimeUnit.SECONDS));
    assertEquals(1, transactions.get() - before);
    List<String> names = IntStream.range(0, 50).mapToObj(i -> "crate " + i).toList();
    assertEquals(names, told);
    assertEquals(names, names());
  }

  @Test
  void whatCanNeverBeStoredStopsNothingBesideIt() throws Exception {
    holdBack();
    List<String> refused = new CopyOnWriteArrayList<>();
    writer.write(() -> add("before"), () -> {});
    writer.write(
        "r7",
        () -> add("a name too long for its column ".repeat(10)),
        () -> refused.add("stored"),
        refusal -> refused.add("refused"));
    writer.write(() -> add("after"), stored::countDown);
    goOn.countDown();

    assertTrue(stored.await(GUARD_SECONDS, TimeUnit.SECONDS));
    assertEquals(List.of("refused"), refused);
    assertEquals(List.of("before", "after"), names());
    assertTrue(leftOut.element().english().contains("r7"), leftOut::toString);
  }

  @Test
  void whoWaitsForAnAnswerIsTriedByHimself() throws Exception {
    holdBack();
    List<String> told = new CopyOnWriteArrayList<>();
    writer.write(() -> add("before"), () -> told.add("before"));
    writer.tryOnce(
        () -> {
          throw new StoreException("away", null);
        },
        () -> told.add("stored"),
        failure -> told.add("failed"));
    writer.write(() -> add("after"), () -> told.add("after"));
    writer.write(() -> {}, stored::countDown);
    goOn.countDown();

    assertTrue(stored.await(GUARD_SECONDS, TimeUnit.SECONDS));
    assertEquals(List.of("before", "failed", "after"), told);
    assertEquals(List.of("before", "after"), names());
  }

  @Test
  void anAnswerThatFailsKeepsNoOtherBack() throws Exception {
    holdBack();
    writer.write(
        () -> {},
        () -> {
          throw new IllegalStateException("said by the test");
        });
    writer.write(() -> add("after"), stored::countDown);
    goOn.countDown();

    assertTrue(stored.await(GUARD_SECONDS, TimeUnit.SECONDS));
  }

  /** The writer is at work, so that others wait, until {@link #goOn}. */
  private void holdBack() throws InterruptedException {
    CountDownLatch isAtWork = new CountDownLatch(1);
    writer.write(
        () -> {
          isAtWork.countDown();
          try {
            goOn.await();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        },
        () -> {});
    assertTrue(isAtWork.await(GUARD_SECONDS, TimeUnit.SECONDS));
  }

  private List<String> names() {
    return store.openTasks().stream().map(task -> task.mission().task().name()).toList();
  }

  private void add(String name) {
    store.addTasks(List.of(new Submission(LabTask.of(name, "ann", AT), UUID.randomUUID())));
  }
}
