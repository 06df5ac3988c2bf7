package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.toqa.allocation.Policy;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.trust.PairingCode;
import org.toqa.persistence.StoreException;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.testbed.Hall;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** A part of the fleet that fails, ends or hangs is seen. */
class FleetHealthTest {
  private static final Duration GUARD = Duration.ofSeconds(60);
  private static final Instant NOW = Hall.START;

  /** Real robots are not what these tests are about. */
  private static final RobotLinkFactory NO_LINKS =
      new RobotLinkFactory() {
        @Override
        public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
          throw new IllegalStateException("no link can be made");
        }

        @Override
        public PairingResult pair(RobotAddress robot, PairingCode code) {
          return new PairingResult.Unreachable(Sentence.verbatim("No robot is there."));
        }
      };

  private final Database database = MemoryDatabase.open("health-" + System.nanoTime());
  private final JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
  private final WatchedRuntime runtime = new WatchedRuntime();
  private volatile InstantSource clock = () -> NOW;
  private @Nullable AgentFleet fleet;

  @AfterEach
  void close() {
    if (fleet != null) {
      fleet.close();
    }
    database.close();
  }

  @Test
  void itDoesNotStartWithAFloorThatFailedToStart() {
    runtime.brokenExecutor = "store-floor-hall";

    IllegalStateException refusal =
        assertThrows(IllegalStateException.class, () -> open(store).close());

    assertTrue(
        refusal.toString().contains("hall") && refusal.toString().contains("no such thread"),
        refusal::toString);
  }

  @Test
  void itDoesNotStartWithARobotWhoseAgentFailedToStart() {
    store.saveRobot(RobotRecord.direct("r1", "hall", "127.0.0.1", 1, 5, null, false, null));

    IllegalStateException refusal =
        assertThrows(IllegalStateException.class, () -> open(store).close());

    assertTrue(refusal.toString().contains("r1"), refusal::toString);
  }

  @Test
  void itDoesNotStartWhereTheStoreCannotBeRead() {
    FleetStore unreadable =
        TamperedStore.of(
            store,
            (method, arguments, real) -> {
              if (method.equals("openTasks")) {
                throw new StoreException("table tasks is broken", null);
              }
              return real.go();
            });

    IllegalStateException refusal =
        assertThrows(IllegalStateException.class, () -> open(unreadable).close());

    assertTrue(refusal.toString().contains("table tasks is broken"), refusal::toString);
  }

  @Test
  void anAgentThatThrowsAgainAndAgainIsAFailureUntilItDoesNoMore() throws Exception {
    AgentFleet running = open(store);
    clock =
        () -> {
          throw new IllegalStateException("no time");
        };
    var _ = submit(running);
    clock = () -> NOW;
    running.rejections(List.of(), "Max").toCompletableFuture().join();
    assertEquals(List.of(), running.failures(), "one surprise is none");

    clock =
        () -> {
          throw new IllegalStateException("no time");
        };
    for (int i = 0; i < 5; i++) {
      var _ = submit(running);
    }

    Sentence failure = Phrase.PART_FAILS.with(Phrase.DISPATCH_PART.with(Hall.floor().name()));
    await(() -> running.failures().equals(List.of(failure)));
    await(() -> running.snapshots().latest().alerts().contains(failure));
    clock = () -> NOW;
    runtime.nanos.addAndGet(Duration.ofMinutes(1).toNanos());
    assertEquals(List.of(), running.failures());
    await(() -> !running.snapshots().latest().alerts().contains(failure));
  }

  @Test
  void anOrderThatThrowsWhileItIsCheckedHoldsUpNoOther() throws Exception {
    AgentFleet running = open(store);
    clock =
        () -> {
          throw new IllegalStateException("no time");
        };
    var failed = submit(running).toCompletableFuture();
    assertThrows(ExecutionException.class, () -> failed.get(GUARD.toSeconds(), TimeUnit.SECONDS));
    clock = () -> NOW;

    var next = submit(running).toCompletableFuture();
    assertInstanceOf(Answer.class, next.get(GUARD.toSeconds(), TimeUnit.SECONDS));
  }

  @Test
  void agentsThatEndedAreAFailure() throws Exception {
    AgentFleet running = open(store);
    clock =
        () -> {
          throw new OutOfMemoryError("said by the test");
        };

    var _ = submit(running);

    running.whenFailed().toCompletableFuture().get(GUARD.toSeconds(), TimeUnit.SECONDS);
    clock = () -> NOW;
    Sentence failure = Phrase.FLEET_ENDED.with();
    assertEquals(List.of(failure), running.failures());
    await(() -> running.snapshots().latest().alerts().contains(failure));
  }

  @Test
  void agentsThatWereClosedDidNotFail() throws Exception {
    AgentFleet running = open(store);

    running.close();

    assertFalse(running.whenFailed().toCompletableFuture().isDone());
    assertEquals(List.of(), running.failures());
  }

  @Test
  void aFleetThatDoesNotAnswerItsClockIsAFailure() throws Exception {
    AgentFleet running = open(store);
    CountDownLatch asked = new CountDownLatch(1);
    CountDownLatch goesOn = new CountDownLatch(1);
    clock =
        () -> {
          asked.countDown();
          waitFor(goesOn);
          return NOW;
        };
    var _ = submit(running);
    waitFor(asked);
    running.tick(NOW.plusMillis(100));
    running.tick(NOW.plusMillis(200));
    runtime.nanos.addAndGet(Duration.ofSeconds(9).toNanos());
    assertEquals(List.of(), running.failures());

    runtime.nanos.addAndGet(Duration.ofSeconds(12).toNanos());

    Sentence failure = Phrase.FLEET_STANDS.with(21L);
    assertEquals(List.of(failure), running.failures());
    await(() -> running.snapshots().latest().alerts().contains(failure));
    goesOn.countDown();
    await(() -> running.failures().isEmpty());
  }

  private AgentFleet open(FleetStore read) {
    fleet =
        new AgentFleet(
            FloorsInMemory.of(Hall.floor()),
            read,
            new JdbiScheduleStore(database.jdbi()),
            NO_LINKS,
            Policy.OPTIMAL.method(),
            new FleetRules(Duration.ofSeconds(30), ChargingRules.USUAL, 1),
            () -> clock.instant(),
            NOW,
            runtime);
    return fleet;
  }

  private static CompletionStage<Answer<TaskView>> submit(AgentFleet fleet) {
    return fleet.submit(
        new TaskOrder(
            "crate",
            1,
            new TaskOrder.Where.Station("A"),
            new TaskOrder.Where.Station("B"),
            null,
            0,
            null,
            null),
        "Max",
        UUID.randomUUID());
  }

  /** For what looks by the clock of the machine, as whoever watches over the fleet does. */
  static void await(BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + GUARD.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "it does not come to be so");
      TimeUnit.MILLISECONDS.sleep(10);
    }
  }

  private static void waitFor(CountDownLatch latch) {
    try {
      assertTrue(latch.await(GUARD.toSeconds(), TimeUnit.SECONDS));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** The threads of a server, and time that the test brings. */
  private static final class WatchedRuntime extends ServerRuntime {
    final AtomicLong nanos = new AtomicLong();
    volatile String brokenExecutor = "";

    @Override
    public ExecutorService serialExecutor(String name) {
      if (name.equals(brokenExecutor)) {
        throw new IllegalStateException("no such thread");
      }
      return super.serialExecutor(name);
    }

    @Override
    public long monotonicNanos() {
      return nanos.get();
    }
  }
}
