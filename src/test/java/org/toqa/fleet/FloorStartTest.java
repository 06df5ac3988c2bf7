package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.allocation.Policy;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.mission.TaskState;
import org.toqa.persistence.StoreException;

/** The store falls silent when a map has just come in force, so that its floor cannot start. */
@Timeout(60)
class FloorStartTest {
  private static final int LAST_COLUMN = 14;

  private final FleetStage stage =
      new FleetStage(
          HallFleetTest.FLOOR,
          ChargingRules.USUAL,
          Policy.OPTIMAL.method(),
          store ->
              TamperedStore.of(
                  store,
                  (method, arguments, call) -> {
                    if (method.equals("floorHolds") && isStoreAway()) {
                      throw new StoreException("The database does not answer.", null);
                    }
                    return call.go();
                  }));

  private volatile boolean isStoreAway;

  private boolean isStoreAway() {
    return isStoreAway;
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void floorStandsUntilTheStoreAnswersAndThenCarries() throws Exception {
    stage.add("r1", HallFleetTest.WEST, "P1");
    stage.restart();
    isStoreAway = true;

    publish("hall");

    assertEquals(
        List.of(
            "The floor hall cannot start: The part of the server that gives tasks to the robots of"
                + " the floor hall cannot start: The database does not answer."),
        failures());
    ExecutionException refused = assertThrows(ExecutionException.class, () -> answer(submit()));
    assertInstanceOf(StoreException.class, refused.getCause());

    isStoreAway = false;
    while (!failures().isEmpty()) {
      TimeUnit.MILLISECONDS.sleep(50); // it is tried again every few seconds
    }
    long task = accepted(submit()).id();
    stage.await(
        view -> view.tasks().stream().anyMatch(t -> t.id() == task && t.state() == TaskState.DONE));
  }

  private List<String> failures() {
    return stage.fleet.failures().stream().map(sentence -> sentence.english()).toList();
  }

  private void publish(String floor) throws Exception {
    FloorEditing editing = stage.fleet.floorEditing();
    FloorDraft draft = editing.draft(floor).orElseThrow();
    FloorDrawing before = draft.drawing();
    BitSet walls = before.walls().occupied();
    walls.set(LAST_COLUMN);
    FloorDrawing next = before.withWalls(before.walls().withOccupied(walls));
    long saved = accepted(editing.saveDraft(floor, next, draft.revision(), "Max")).revision();
    FloorMap map = accepted(editing.publish(floor, saved, "Max"));
    assertEquals(next, map.drawing());
  }

  private CompletionStage<Answer<TaskView>> submit() {
    return stage.fleet.submit(HallFleetTest.order(2), "Max", UUID.randomUUID());
  }

  private static <T> Answer<T> answer(CompletionStage<Answer<T>> answer) throws Exception {
    return answer.toCompletableFuture().get(10, TimeUnit.SECONDS);
  }

  private static <T> T accepted(CompletionStage<Answer<T>> answer) throws Exception {
    Answer<T> given = answer(answer);
    assertTrue(given instanceof Answer.Accepted<T>, given::toString);
    return ((Answer.Accepted<T>) given).value();
  }
}
