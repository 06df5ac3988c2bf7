package org.toqa.fleet.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import java.util.Queue;
import java.util.UUID;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.StoreWriter;
import org.toqa.fleet.TamperedStore;
import org.toqa.mission.TransportTask;
import org.toqa.persistence.StoreException;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.testbed.LabTask;

@Timeout(60)
class TaskSubmitterTest {
  private static final int TASKS = 20;

  private final Database database = MemoryDatabase.open("intake-" + System.nanoTime());
  private final JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
  private final StoreWriter writer =
      new StoreWriter("test", FleetRuntime.USUAL, store::inOneTransaction, change -> {});
  private final Queue<Integer> transactions = new ConcurrentLinkedQueue<>();
  private final Queue<TransportTask> accepted = new ConcurrentLinkedQueue<>();
  private final Queue<StoreException> refusals = new ConcurrentLinkedQueue<>();
  private final CountDownLatch firstIsUnderWay = new CountDownLatch(1);
  private final CountDownLatch othersHaveCome = new CountDownLatch(1);
  private final CountDownLatch answered = new CountDownLatch(TASKS);

  @AfterEach
  void close() {
    writer.close();
    database.close();
  }

  @Test
  void whatComesDuringOneTransactionGoesIntoTheNext() throws Exception {
    takeAll(
        new TaskSubmitter(
            TamperedStore.of(store, (method, arguments, call) -> delayed(call, arguments)),
            writer,
            new PendingSubmissions(),
            System::nanoTime));

    assertEquals(List.of(1, TASKS - 1), List.copyOf(transactions));
    assertEquals(names(), accepted.stream().map(TransportTask::name).toList());
    assertEquals(
        accepted.stream().map(TransportTask::id).toList(),
        store.openTasks().stream().map(t -> t.mission().id()).toList());
  }

  @Test
  void allOfATransactionThatFailsAreRefusedAndNotStoredLater() throws Exception {
    takeAll(
        new TaskSubmitter(
            TamperedStore.of(
                store,
                (method, arguments, call) -> {
                  if (!method.equals("addTasks")) {
                    return call.go();
                  }
                  Object stored = delayed(call, arguments);
                  if (transactions.size() == 1) {
                    return stored;
                  }
                  throw new StoreException("It was stored, but nobody knows.", null);
                }),
            writer,
            new PendingSubmissions(),
            System::nanoTime));
    writer.close(); // what was to be withdrawn, is

    assertEquals(List.of("0"), accepted.stream().map(TransportTask::name).toList());
    assertEquals(1, store.count());
  }

  @Test
  void whatComesToTheStoreTooLateIsRefusedAndNothingIsWithdrawn() throws Exception {
    UUID key = UUID.randomUUID();
    Submission submission = new Submission(task("late"), key);
    store.addTasks(List.of(submission)); // asked for again meanwhile, and accepted
    TaskSubmitter submitter =
        new TaskSubmitter(store, writer, new PendingSubmissions(), System::nanoTime);
    CountDownLatch refused = new CountDownLatch(1);

    submitter.submit(
        List.of(submission), System.nanoTime() - 1, accepted::addAll, e -> refused.countDown());

    assertTrue(refused.await(20, TimeUnit.SECONDS));
    writer.close();
    assertTrue(accepted.isEmpty());
    assertEquals(1, store.count());
  }

  @Test
  void anOrderThatCanNeverBeStoredRefusesNoOther() throws Exception {
    TaskSubmitter intake =
        new TaskSubmitter(
            TamperedStore.of(
                store,
                (method, arguments, call) ->
                    method.equals("addTasks") && transactions.size() < 2
                        ? delayed(call, arguments)
                        : call.go()),
            writer,
            new PendingSubmissions(),
            System::nanoTime);
    take(intake, 0);
    assertTrue(firstIsUnderWay.await(20, TimeUnit.SECONDS));
    take(intake, "too long for its column ".repeat(10));
    IntStream.range(2, TASKS).forEach(i -> take(intake, i));
    othersHaveCome.countDown();
    assertTrue(answered.await(20, TimeUnit.SECONDS));

    assertEquals(TASKS - 1, accepted.size());
    assertEquals(TASKS - 1, store.count());
  }

  @Test
  void whatWasAcceptedStaysWhenTheStoreFailsOnAnotherOneAfterIt() throws Exception {
    TaskSubmitter intake =
        new TaskSubmitter(
            TamperedStore.of(
                store,
                (method, arguments, call) -> {
                  if (!method.equals("addTasks")) {
                    return call.go();
                  }
                  if (names(arguments).contains("faulty")) {
                    throw new IllegalStateException("A fault of this program.");
                  }
                  return delayed(call, arguments);
                }),
            writer,
            new PendingSubmissions(),
            System::nanoTime);
    take(intake, 0);
    assertTrue(firstIsUnderWay.await(20, TimeUnit.SECONDS));
    IntStream.range(1, TASKS - 1).forEach(i -> take(intake, i));
    take(intake, "faulty");
    othersHaveCome.countDown();
    assertTrue(answered.await(20, TimeUnit.SECONDS));
    writer.close(); // what was to be withdrawn, is

    assertEquals(1, refusals.size());
    assertEquals(TASKS - 1, accepted.size());
    assertEquals(
        accepted.stream().map(TransportTask::id).toList(),
        store.openTasks().stream().map(t -> t.mission().id()).toList());
  }

  @Test
  void whatWasAcceptedStaysWhenItsCallerFailsOnTheAnswer() throws Exception {
    CountDownLatch refused = new CountDownLatch(1);
    TaskSubmitter intake =
        new TaskSubmitter(store, writer, new PendingSubmissions(), System::nanoTime);

    intake.submit(
        List.of(new Submission(task("told"), UUID.randomUUID())),
        TaskSubmitter.deadline(System.nanoTime()),
        tasks -> {
          accepted.addAll(tasks);
          throw new IllegalStateException("A fault of who asked.");
        },
        failure -> refused.countDown());
    take(intake, "next");
    writer.close();

    assertEquals(1, refused.getCount());
    assertEquals(2, accepted.size());
    assertEquals(2, store.count());
  }

  private void takeAll(TaskSubmitter intake) throws InterruptedException {
    take(intake, 0);
    assertTrue(firstIsUnderWay.await(20, TimeUnit.SECONDS));
    IntStream.range(1, TASKS).forEach(i -> take(intake, i));
    othersHaveCome.countDown();
    assertTrue(answered.await(20, TimeUnit.SECONDS));
  }

  private void take(TaskSubmitter intake, int number) {
    take(intake, String.valueOf(number));
  }

  private void take(TaskSubmitter intake, String name) {
    intake.submit(
        List.of(new Submission(task(name), UUID.randomUUID())),
        TaskSubmitter.deadline(System.nanoTime()),
        tasks -> {
          accepted.addAll(tasks);
          answered.countDown();
        },
        failure -> {
          refusals.add(failure);
          answered.countDown();
        });
  }

  private Object delayed(TamperedStore.Call call, Object[] arguments) throws Throwable {
    transactions.add(((List<?>) arguments[0]).size());
    firstIsUnderWay.countDown();
    assertTrue(othersHaveCome.await(20, TimeUnit.SECONDS));
    return call.go();
  }

  private static List<String> names(Object[] submissions) {
    return ((List<?>) submissions[0])
        .stream().map(submission -> ((Submission) submission).task().name()).toList();
  }

  private static List<String> names() {
    return IntStream.range(0, TASKS).mapToObj(String::valueOf).toList();
  }

  private static TransportTask task(String name) {
    return LabTask.of(name, "ann", Instant.parse("2026-11-21T10:00:00Z"));
  }
}
