package org.toqa.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.fail;

import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;
import org.toqa.allocation.Policy;
import org.toqa.fleet.Answer;
import org.toqa.fleet.ChargingRules;
import org.toqa.fleet.FleetStage;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.PartsOrder;
import org.toqa.fleet.TamperedStore;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskView;
import org.toqa.grid.FloorReader;
import org.toqa.mission.OrderPart;
import org.toqa.persistence.StoreException;
import org.toqa.store.JdbiAccountStore;
import org.toqa.store.JdbiOrderArchive;
import org.toqa.store.LastKnownUsers;

/** A task that was accepted is never withdrawn, whatever became of its first submission. */
@Timeout(120)
class AcceptedTaskTest {
  /** What happens once when tasks have been stored. */
  private final AtomicReference<@Nullable Runnable> afterStored = new AtomicReference<>();

  private FleetStage stage;
  private IdempotentSubmitter submitter;
  private Account clara;
  private UUID key;

  @BeforeEach
  void start() throws Exception {
    stage =
        new FleetStage(
            FloorReader.read(Path.of("maps", "lab.yaml")),
            ChargingRules.USUAL,
            Policy.OPTIMAL.method(),
            store ->
                TamperedStore.of(
                    store,
                    (method, arguments, call) -> {
                      Object result = call.go();
                      if (method.equals("addTasks")) {
                        Runnable next = afterStored.getAndSet(null);
                        if (next != null) {
                          next.run();
                        }
                      }
                      return result;
                    }));
    submitter =
        new IdempotentSubmitter(
            stage.fleet, stage.store, new JdbiOrderArchive(stage.database.jdbi()));
    clara =
        new JdbiAccountStore(stage.database.jdbi(), InstantSource.system(), new LastKnownUsers())
            .add("clara", "hash", Role.CLERK, "boss")
            .orElseThrow();
    key = IdempotentSubmitter.idempotencyKey(clara, "a");
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void aTaskOfWhichNobodyKnowsIsNotAnsweredBeforeItIsWithdrawn() throws Exception {
    afterStored.set(this::loseAnswerAndStore);

    assertThrows(StoreException.class, this::submit);
    assertThrows(StoreException.class, this::submit, "it is still there, and will not stay");
    assertAcceptedAfterwards();
  }

  @Test
  void aTaskThatWasStoredTooLateIsNotAnsweredBeforeItIsWithdrawn() throws Exception {
    afterStored.set(
        () -> {
          stage.passAnswerTime(Duration.ofSeconds(9));
          stage.stopStoreFor(agent -> agent.startsWith("tasks-"));
        });

    assertThrows(StoreException.class, this::submit);
    assertThrows(StoreException.class, this::submit);

    assertAcceptedAfterwards();
  }

  @Test
  void tasksThatCameTogetherAreNotAnsweredBeforeTheyAreWithdrawn() throws Exception {
    afterStored.set(this::loseAnswerAndStore);
    PartsOrder order = new PartsOrder("pieces", OrderPart.Kind.PIECES, List.of(order(), order()));

    assertThrows(StoreException.class, () -> submitter.submitOrder(order, clara, key));
    assertThrows(StoreException.class, () -> submitter.submitOrder(order, clara, key));

    startStore();
    assertInstanceOf(
        IdempotentSubmitter.BatchOutcome.Answered.class, submitter.submitOrder(order, clara, key));
    assertInstanceOf(
        IdempotentSubmitter.BatchOutcome.Repeated.class, submitter.submitOrder(order, clara, key));
    stage.awaitQuiescence();
    assertEquals(2, stage.store.count());
  }

  private void loseAnswerAndStore() {
    stage.stopStoreFor(agent -> agent.startsWith("tasks-"));
    throw new StoreException("It was stored, but nobody knows.", null);
  }

  private void startStore() throws InterruptedException {
    stage.startStore();
    stage.awaitQuiescence();
  }

  private void assertAcceptedAfterwards() throws InterruptedException {
    startStore();
    TaskView task =
        switch (submit()) {
          case KeyedAnswer.Answered<TaskView>(Answer.Accepted<TaskView>(TaskView accepted)) ->
              accepted;
          case KeyedAnswer<TaskView> other -> fail("No: " + other);
        };
    stage.awaitQuiescence();
    assertEquals(task.id(), stage.store.taskByKey(key).orElseThrow().id());
    assertInstanceOf(KeyedAnswer.Repeated.class, submit());
    assertEquals(1, stage.store.count());
  }

  private KeyedAnswer<TaskView> submit() {
    return submitter.submit(order(), clara, key);
  }

  private static TaskOrder order() {
    return new TaskOrder(
        "crate",
        1,
        new Where.Station("Goods-in 1"),
        new Where.Station("Mill"),
        null,
        0,
        null,
        null);
  }
}
