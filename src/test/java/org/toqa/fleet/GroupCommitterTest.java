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
class GroupCommitterTest {
  private static final long GUARD_SECONDS = 20;
  private static final Instant AT = Instant.parse("2026-11-21T10:00:00Z");
  private static final String TOO_LONG = "a name too long for its column ".repeat(10);

  private final Database database = MemoryDatabase.open("writer-" + System.nanoTime());
  private final JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
  private final AtomicInteger groups = new AtomicInteger();
  private final Queue<Sentence> leftOut = new ConcurrentLinkedQueue<>();
  private final GroupCommitter committer =
      new GroupCommitter(
          "test",
          TamperedStore.of(
              store,
              (method, arguments, real) -> {
                if (method.equals("saveTogether")) {
                  groups.incrementAndGet();
                }
                return real.go();
              }),
          FleetRuntime.USUAL,
          leftOut::add);
  private final StoreWriter writer = committer.writer();
  private final CountDownLatch stored = new CountDownLatch(1);
  private final CountDownLatch firstIsUnderWay = new CountDownLatch(1);
  private final CountDownLatch othersHaveCome = new CountDownLatch(1);

  @AfterEach
  void close() {
    committer.close();
    database.close();
  }

  @Test
  void whatCanNeverBeStoredStopsNothingBehindIt() throws Exception {
    writer.write(() -> add(TOO_LONG), () -> {});
    writer.write(() -> add("crate"), stored::countDown);

    awaitStored();
    assertEquals(List.of("crate"), names());
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

    awaitStored();
  }

  @Test
  void whoCannotBeToldStopsNothingBehindHim() throws Exception {
    writer.write(
        () -> add("first"),
        () -> {
          throw new IllegalStateException("said by the test");
        });
    writer.write(() -> add("second"), stored::countDown);

    awaitStored();
    assertEquals(List.of("first", "second"), names());
  }

  @Test
  void anOutageIsTriedAgainAndAllOthersWait() throws Exception {
    AtomicInteger tries = new AtomicInteger();
    writer.write(
        () -> {
          if (tries.incrementAndGet() < 3) {
            throw away();
          }
          add("first");
        },
        () -> {});
    writer.write(() -> add("second"), stored::countDown);

    awaitStored();
    assertEquals(List.of("first", "second"), names());
  }

  @Test
  void whatComesDuringOneTransactionGoesIntoTheNext() throws Exception {
    Queue<Integer> inTheStoreWhenTold = new ConcurrentLinkedQueue<>();
    holdUpFirst();
    for (int i = 0; i < 50; i++) {
      String name = "robot " + i;
      committer.writer(name).write(() -> add(name), () -> inTheStoreWhenTold.add(names().size()));
    }
    writer.write(() -> {}, stored::countDown);
    othersHaveCome.countDown();

    awaitStored();
    assertEquals(1, groups.get());
    assertEquals(List.of(51), inTheStoreWhenTold.stream().distinct().toList(), "all are safe");
    assertEquals(50, inTheStoreWhenTold.size());
  }

  @Test
  void oneOfAGroupThatCanNeverBeStoredIsLeftOutAlone() throws Exception {
    Queue<String> told = new ConcurrentLinkedQueue<>();
    Queue<String> refused = new ConcurrentLinkedQueue<>();
    holdUpFirst();
    for (int i = 0; i < 9; i++) {
      String name = "robot " + i;
      String task = i % 4 == 1 ? TOO_LONG : name;
      committer
          .writer(name)
          .write(() -> add(task), () -> told.add(name), refusal -> refused.add(name));
    }
    writer.write(() -> {}, stored::countDown);
    othersHaveCome.countDown();

    awaitStored();
    List<String> others = List.of("robot 0", "robot 2", "robot 3", "robot 4", "robot 6", "robot 7");
    assertEquals(List.of("robot 1", "robot 5"), List.copyOf(refused));
    assertEquals(
        IntStream.of(0, 2, 3, 4, 6, 7, 8).mapToObj(i -> "robot " + i).toList(), List.copyOf(told));
    assertTrue(names().containsAll(others));
    assertEquals(8, names().size());
  }

  /** As one whose row somebody else has locked. */
  @Test
  void oneThatFailsWhileTheStoreAnswersKeepsOnlyItsOwnWriterWaiting() throws Exception {
    CountDownLatch othersAreStored = new CountDownLatch(1);
    holdUpFirst();
    StoreWriter locked = committer.writer("locked");
    locked.write(
        () -> {
          if (othersAreStored.getCount() > 0) {
            throw away();
          }
          add("locked 1");
        },
        () -> {});
    locked.write(() -> add("locked 2"), stored::countDown);
    committer.writer("free").write(() -> add("free"), othersAreStored::countDown);
    othersHaveCome.countDown();

    awaitStored();
    assertEquals(List.of("first", "free", "locked 1", "locked 2"), names());
  }

  @Test
  void ofWhatIsOnlyOfInterestUntilTheNextComesTheNewestIsStored() throws Exception {
    holdUpFirst();
    writer.writeNewest("place of r1", () -> add("here"), () -> {});
    writer.writeNewest("place of r2", () -> add("elsewhere"), () -> {});
    for (int i = 0; i < 100_000; i++) {
      writer.writeNewest("place of r1", () -> add("there"), stored::countDown);
    }
    othersHaveCome.countDown();

    awaitStored();
    assertEquals(List.of("first", "elsewhere", "there"), names());
  }

  @Test
  void linesAreLeftOutWhereVeryManyWait() throws Exception {
    AtomicInteger lines = new AtomicInteger();
    holdUpFirst();
    for (int i = 0; i < 100_000; i++) {
      writer.writeLine(lines::incrementAndGet);
    }
    writer.write(() -> {}, stored::countDown);
    othersHaveCome.countDown();

    awaitStored();
    assertEquals(10_000, lines.get());
    assertEquals(90_000, leftOut.size());
    assertEquals(List.of(Phrase.LINES_LEFT_OUT.with("test")), leftOut.stream().distinct().toList());
  }

  @Test
  void whoseCallerWaitsIsTriedOnceAndAlone() throws Exception {
    Queue<StoreException> failures = new ConcurrentLinkedQueue<>();
    AtomicInteger tries = new AtomicInteger();
    holdUpFirst();
    writer.write(() -> add("before"), () -> {});
    writer.tryOnce(
        () -> {
          tries.incrementAndGet();
          throw away();
        },
        () -> {},
        failures::add);
    writer.write(() -> add("after"), stored::countDown);
    othersHaveCome.countDown();

    awaitStored();
    assertEquals(1, tries.get());
    assertEquals(1, failures.size());
    assertEquals(List.of("first", "before", "after"), names());
    assertEquals(0, groups.get());
  }

  /** All that is written until {@link #othersHaveCome} waits. */
  private void holdUpFirst() throws InterruptedException {
    writer.write(
        () -> {
          firstIsUnderWay.countDown();
          awaitEnd(othersHaveCome);
          add("first");
        },
        () -> {});
    assertTrue(firstIsUnderWay.await(GUARD_SECONDS, TimeUnit.SECONDS));
  }

  private static void awaitEnd(CountDownLatch latch) {
    try {
      assertTrue(latch.await(GUARD_SECONDS, TimeUnit.SECONDS));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void awaitStored() throws InterruptedException {
    assertTrue(stored.await(GUARD_SECONDS, TimeUnit.SECONDS));
  }

  private static StoreException away() {
    return new StoreException("away", new SQLTransientConnectionException("no connection"));
  }

  private List<String> names() {
    return store.openTasks().stream().map(task -> task.mission().task().name()).toList();
  }

  private void add(String name) {
    store.addTasks(List.of(new Submission(LabTask.of(name, "ann", AT), UUID.randomUUID())));
  }
}
