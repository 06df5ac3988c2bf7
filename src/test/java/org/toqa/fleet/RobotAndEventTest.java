package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.allocation.Policy;
import org.toqa.persistence.StoreException;

/** A robot that is stored, and the line of the history that tells of it: both or none. */
@Timeout(60)
class RobotAndEventTest {
  /** What the store is still asked for before it goes away. */
  private final AtomicInteger changesLeft = new AtomicInteger(Integer.MAX_VALUE);

  private FleetStage stage;

  @BeforeEach
  void start() {
    stage =
        new FleetStage(
            HallFleetTest.FLOOR,
            ChargingRules.USUAL,
            Policy.OPTIMAL.method(),
            store ->
                TamperedStore.of(
                    store,
                    (method, arguments, call) -> {
                      boolean isChange = method.startsWith("save") || method.startsWith("add");
                      if (isChange && changesLeft.getAndDecrement() == 0) {
                        throw new StoreException("It is away.", null);
                      }
                      return call.go();
                    }));
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void aStoreThatGoesAwayAfterOneChangeHasBothOrNone() throws InterruptedException {
    changesLeft.set(1);

    await(stage.fleet.addRobot(new RobotOrder("r9", "127.0.0.1", 1, 5, null, null), "Max"));
    stage.awaitQuiescence();

    int told =
        stage
            .database
            .jdbi()
            .withHandle(
                h ->
                    h.createQuery("select count(*) from events where kind = 'robot.added'")
                        .mapTo(Integer.class)
                        .one());
    assertEquals(stage.store.robots().size(), told);
  }

  private static void await(CompletionStage<?> answer) {
    try {
      answer.toCompletableFuture().join();
    } catch (CompletionException e) {
      // the same to this test
    }
  }
}
