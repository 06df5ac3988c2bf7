package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.lab.experiment.Run.ProgressListener;
import org.toqa.lab.record.ExperimentRunner;
import org.toqa.lab.record.LabOrder;
import org.toqa.lab.record.LabResult;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.LabRunState;
import org.toqa.lab.record.LabRunStore;
import org.toqa.lab.record.Laboratory;
import org.toqa.lab.record.Laboratory.Ordered;
import org.toqa.persistence.StoreException;

/** The queue of the laboratory, over a store and experiments that go on until a test says so. */
class LaboratoryTest extends DatabaseTest {
  private static final int PATIENCE_SECONDS = 60;

  private final Semaphore slot = new Semaphore(1, true);
  private final HeldExperiments experiments = new HeldExperiments();

  /** Each goes on until the test gives it its end, or it is stopped. */
  private static final class HeldExperiments implements ExperimentRunner {
    final BlockingQueue<Long> begun = new LinkedBlockingQueue<>();
    final BlockingQueue<Outcome> ends = new LinkedBlockingQueue<>();
    final AtomicInteger running = new AtomicInteger();
    final AtomicInteger mostRunning = new AtomicInteger();

    @Override
    public Outcome run(LabOrder order, ProgressListener listener, BooleanSupplier isStopped)
        throws InterruptedException {
      mostRunning.accumulateAndGet(running.incrementAndGet(), Math::max);
      try {
        listener.progress(0.25, "step of " + order.seed());
        begun.add(order.seed());
        while (!isStopped.getAsBoolean()) {
          @Nullable Outcome end = ends.poll(10, TimeUnit.MILLISECONDS);
          if (end != null) {
            return end;
          }
        }
        return new Outcome.Stopped();
      } finally {
        running.decrementAndGet();
      }
    }

    long awaitBegun() throws InterruptedException {
      Long seed = begun.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
      return seed == null ? -1 : seed;
    }
  }

  private Laboratory laboratory() {
    return new Laboratory(
        new JdbiLabRunStore(database.jdbi()), experiments, slot, InstantSource.system());
  }

  /** A store that fails where a test says so. */
  private final class Store {
    final Map<String, StoreException> failures = new ConcurrentHashMap<>();
    final BlockingQueue<String> failed = new LinkedBlockingQueue<>();
    private final LabRunStore kept = new JdbiLabRunStore(database.jdbi());

    void fail(StoreException failure, String... methods) {
      for (String method : methods) {
        failures.put(method, failure);
      }
    }

    void awaitFailed(String method) throws InterruptedException {
      assertEquals(method, failed.poll(PATIENCE_SECONDS, TimeUnit.SECONDS));
    }

    Laboratory laboratory() {
      Object store =
          Proxy.newProxyInstance(
              LabRunStore.class.getClassLoader(),
              new Class<?>[] {LabRunStore.class},
              (_, method, arguments) -> {
                @Nullable StoreException failure = failures.get(method.getName());
                if (failure != null) {
                  failed.add(method.getName());
                  throw failure;
                }
                return method.invoke(kept, arguments);
              });
      return new Laboratory((LabRunStore) store, experiments, slot, InstantSource.system());
    }
  }

  private static final StoreException AWAY = new StoreException("away", null);

  private static void close(Laboratory laboratory) throws Exception {
    CompletableFuture.runAsync(laboratory::close).get(20, TimeUnit.SECONDS);
  }

  private static LabOrder order(long seed) {
    return new LabOrder("csm-budget", seed, 1, Map.of());
  }

  private static long start(Laboratory laboratory, long seed) {
    return assertInstanceOf(Ordered.Queued.class, laboratory.start(order(seed), "Max")).run().id();
  }

  private static void awaitState(Laboratory laboratory, long id, LabRunState state)
      throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    while (laboratory.store().run(id).orElseThrow().state() != state && System.nanoTime() < end) {
      TimeUnit.MILLISECONDS.sleep(5);
    }
    assertEquals(state, laboratory.store().run(id).orElseThrow().state());
  }

  @Test
  void runsGoOnInTheirOrderOneAtATimeAlsoOfSeveralSites() throws Exception {
    try (Laboratory one = laboratory();
        Database elsewhere = MemoryDatabase.open("store-other-" + System.nanoTime());
        Laboratory other =
            new Laboratory(
                new JdbiLabRunStore(elsewhere.jdbi()), experiments, slot, InstantSource.system())) {
      long first = start(one, 1);
      assertEquals(1, experiments.awaitBegun());
      long second = start(one, 2);
      long foreign = start(other, 3);
      assertEquals(new Laboratory.Progress(0.25, "step of 1"), one.progress(first).orElseThrow());
      assertTrue(one.progress(second).isEmpty());
      for (int i = 0; i < 3; i++) {
        experiments.ends.add(new ExperimentRunner.Outcome.Done(new LabResult("{}", List.of())));
      }
      awaitState(one, first, LabRunState.DONE);
      awaitState(one, second, LabRunState.DONE);
      awaitState(other, foreign, LabRunState.DONE);
      assertEquals(1, experiments.mostRunning.get());
      assertTrue(one.store().report(first).isPresent());
    }
  }

  @Test
  void aRunIsStoppedWhetherItRunsOrWaits() throws Exception {
    try (Laboratory laboratory = laboratory()) {
      long runs = start(laboratory, 1);
      long waits = start(laboratory, 2);
      long after = start(laboratory, 3);
      experiments.awaitBegun();
      assertTrue(laboratory.stop(waits));
      assertEquals(LabRunState.STOPPED, laboratory.store().run(waits).orElseThrow().state());
      assertTrue(laboratory.stop(runs));
      awaitState(laboratory, runs, LabRunState.STOPPED);
      assertEquals(3, experiments.awaitBegun(), "what was stopped does not begin");
      assertTrue(laboratory.stop(after));
      awaitState(laboratory, after, LabRunState.STOPPED);
      assertFalse(laboratory.stop(after), "it is over");
      assertFalse(laboratory.stop(99), "there is none");
    }
  }

  @Test
  void aRunThatFailsSaysWhyAndTheNextOneGoesOn() throws Exception {
    try (Laboratory laboratory = laboratory()) {
      long fails = start(laboratory, 1);
      experiments.ends.add(new ExperimentRunner.Outcome.Failed("no memory"));
      awaitState(laboratory, fails, LabRunState.FAILED);
      assertEquals("no memory", laboratory.store().run(fails).orElseThrow().detail());
      long next = start(laboratory, 2);
      experiments.ends.add(new ExperimentRunner.Outcome.Done(new LabResult("{}", List.of())));
      awaitState(laboratory, next, LabRunState.DONE);
    }
  }

  @Test
  void theNextServerBreaksOffWhatRanAndGoesOnWithWhatWaited() throws Exception {
    long ran;
    long waited;
    try (Laboratory laboratory = laboratory()) {
      ran = start(laboratory, 1);
      waited = start(laboratory, 2);
      experiments.awaitBegun();
    }
    JdbiLabRunStore store = new JdbiLabRunStore(database.jdbi());
    assertEquals(LabRunState.BROKEN_OFF, store.run(ran).orElseThrow().state());
    // as after kill -9, which leaves no time to say so
    long killed = store.add(order(7), "Max", InstantSource.system().instant()).id();
    store.begin(killed, InstantSource.system().instant());

    try (Laboratory next = laboratory()) {
      assertEquals(LabRunState.BROKEN_OFF, store.run(killed).orElseThrow().state());
      assertEquals(2, experiments.awaitBegun());
      experiments.ends.add(new ExperimentRunner.Outcome.Done(new LabResult("{}", List.of())));
      awaitState(next, waited, LabRunState.DONE);
    }
  }

  @Test
  void queueAndArchiveAreBounded() throws Exception {
    try (Laboratory laboratory = laboratory()) {
      start(laboratory, 0);
      experiments.awaitBegun();
      for (int i = 1; i <= Laboratory.MOST_WAITING; i++) {
        start(laboratory, i);
      }
      assertInstanceOf(Ordered.QueueFull.class, laboratory.start(order(99), "Max"));
      for (LabRun run : laboratory.store().runs()) {
        laboratory.stop(run.id());
      }
      for (int i = 0; laboratory.store().runs().size() < Laboratory.MOST_KEPT; i++) {
        LabRun kept = laboratory.store().add(order(i), "Max", InstantSource.system().instant());
        laboratory.stop(kept.id());
      }
      assertInstanceOf(Ordered.ArchiveFull.class, laboratory.start(order(99), "Max"));
      assertTrue(
          laboratory.store().runs().stream()
              .filter(run -> run.state().isOver())
              .findFirst()
              .map(run -> laboratory.store().delete(run.id()))
              .orElseThrow());
      start(laboratory, 99);
    }
  }

  @Test
  void whatARunGaveIsStoredAsSoonAsTheStoreAnswers() throws Exception {
    Store store = new Store();
    try (Laboratory laboratory = store.laboratory()) {
      long id = start(laboratory, 1);
      experiments.awaitBegun();
      store.fail(AWAY, "complete", "end", "breakOff");
      experiments.ends.add(new ExperimentRunner.Outcome.Done(new LabResult("{}", List.of())));
      store.awaitFailed("complete");
      assertFalse(laboratory.stop(id), "it is over");
      assertTrue(slot.tryAcquire(PATIENCE_SECONDS, TimeUnit.SECONDS), "other sites go on");
      slot.release();
      store.failures.clear();
      awaitState(laboratory, id, LabRunState.DONE);
      assertTrue(laboratory.store().report(id).isPresent());
    }
  }

  @Test
  void aRunThatTheStoreDoesNotBeginWaitsUntilItDoes() throws Exception {
    Store store = new Store();
    try (Laboratory laboratory = store.laboratory()) {
      store.fail(AWAY, "begin", "breakOff");
      start(laboratory, 1);
      store.awaitFailed("begin");
      store.failures.clear();
      assertEquals(1, experiments.awaitBegun());
    }
  }

  @Test
  void aResultThatTheStoreRefusesFailsAndTheNextRunGoesOn() throws Exception {
    Store store = new Store();
    try (Laboratory laboratory = store.laboratory()) {
      long id = start(laboratory, 1);
      experiments.awaitBegun();
      store.fail(
          new StoreException(StoreException.Kind.REFUSED, "too much of it", null), "complete");
      experiments.ends.add(new ExperimentRunner.Outcome.Done(new LabResult("{}", List.of())));
      awaitState(laboratory, id, LabRunState.FAILED);
      assertEquals("too much of it", laboratory.store().run(id).orElseThrow().detail());
      start(laboratory, 2);
      assertEquals(2, experiments.awaitBegun());
    }
  }

  @Test
  void itEndsWhileTheStoreIsAwayAndARunGoesOn() throws Exception {
    Store store = new Store();
    Laboratory laboratory = store.laboratory();
    long id = start(laboratory, 1);
    experiments.awaitBegun();
    store.fail(AWAY, "end", "breakOff");
    close(laboratory);
    assertEquals(LabRunState.RUNNING, store.kept.run(id).orElseThrow().state());
    laboratory().close();
    assertEquals(LabRunState.BROKEN_OFF, store.kept.run(id).orElseThrow().state());
  }

  @Test
  void itEndsWhileTheStoreIsAwayAndAResultIsToBeStored() throws Exception {
    Store store = new Store();
    Laboratory laboratory = store.laboratory();
    start(laboratory, 1);
    experiments.awaitBegun();
    store.fail(AWAY, "complete", "end", "breakOff");
    experiments.ends.add(new ExperimentRunner.Outcome.Done(new LabResult("{}", List.of())));
    store.awaitFailed("complete");
    close(laboratory);
  }
}
