package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.allocation.Policy;
import org.toqa.fleet.history.EventArchive;
import org.toqa.geometry.Vec2;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.persistence.StoreException;
import org.toqa.store.JdbiEventArchive;

/** Holds and resumes that the database can never store: who asked is told at once. */
@Timeout(60)
class RefusedHoldTest {
  private static final Set<String> HOLDS =
      Set.of("savePause", "saveFloorHold", "saveHold", "saveMissions");

  private volatile boolean refuses;
  private final FleetStage stage =
      new FleetStage(
          HallFleetTest.FLOOR,
          ChargingRules.USUAL,
          Policy.OPTIMAL.method(),
          store ->
              TamperedStore.of(
                  store,
                  (method, _, real) -> {
                    if (refuses && HOLDS.contains(method)) {
                      throw new StoreException(StoreException.Kind.REFUSED, "too long", null);
                    }
                    return real.go();
                  }));

  @BeforeEach
  void start() throws InterruptedException {
    stage.add("r1", new Vec2(0.5, 0.5), "P1");
    stage.restart();
    stage.await(view -> view.robots().getFirst().state() == RobotState.IDLE);
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void aPauseThatCannotBeStoredIsInForceAndToldAtOnce() throws Exception {
    refuses = true;
    assertRefused(stage.fleet.pauseAll("Max"));
    stage.await(view -> stage.scriptedRobot("r1").isHeld());
  }

  @Test
  void aPauseInForceThatIsNotStoredIsStoredWhenItIsPressedAgain() throws Exception {
    refuses = true;
    assertRefused(stage.fleet.pauseAll("Max"));
    assertRefused(stage.fleet.pauseAll("Max"));
    assertTrue(stage.store.pause().isEmpty());
    refuses = false;

    Optional<Hold> pause = HallFleetTest.accepted(stage.fleet.pauseAll("Clara"));

    assertEquals(pause, stage.store.pause());
    assertEquals("Max", pause.orElseThrow().user(), "he has paused them");
    HallFleetTest.accepted(stage.fleet.pauseAll("Max"));
    EventArchive.Filter told =
        new EventArchive.Filter(null, null, null, "fleet.paused", null, null, false);
    assertEquals(
        1,
        new JdbiEventArchive(stage.database.jdbi()).events(told, Long.MAX_VALUE, 10).size(),
        "told once");
  }

  @Test
  void aHoldOfAFloorInForceThatIsNotStoredIsStoredWhenItIsPressedAgain() throws Exception {
    refuses = true;
    assertRefused(stage.fleet.holdFloor("hall", "Max"));
    assertRefused(stage.fleet.holdFloor("hall", "Max"));
    refuses = false;
    HallFleetTest.accepted(stage.fleet.holdFloor("hall", "Clara"));
    assertEquals("Max", Objects.requireNonNull(stage.store.floorHolds().get("hall")).user());
  }

  @Test
  void aResumeOfAllThatCannotBeStoredMayBeAskedForAgain() throws Exception {
    HallFleetTest.accepted(stage.fleet.pauseAll("Max"));
    stage.await(view -> stage.scriptedRobot("r1").isHeld());
    refuses = true;
    assertRefused(stage.fleet.resumeAll("Max"));
    assertTrue(stage.scriptedRobot("r1").isHeld());
    refuses = false;
    HallFleetTest.accepted(stage.fleet.resumeAll("Max"));
    stage.await(view -> view.pause() == null && !stage.scriptedRobot("r1").isHeld());
  }

  @Test
  void theSameOfAFloor() throws Exception {
    refuses = true;
    assertRefused(stage.fleet.holdFloor("hall", "Max"));
    refuses = false;
    stage.restart();
    HallFleetTest.accepted(stage.fleet.holdFloor("hall", "Max"));
    refuses = true;
    assertRefused(stage.fleet.resumeFloor("hall", "Max"));
    refuses = false;
    HallFleetTest.accepted(stage.fleet.resumeFloor("hall", "Max"));
    stage.await(view -> !stage.scriptedRobot("r1").isHeld());
  }

  @Test
  void theSameOfARobot() throws Exception {
    refuses = true;
    assertRefused(stage.fleet.holdRobot("r1", "Max"));
    stage.await(view -> stage.scriptedRobot("r1").isHeld());
    assertRefused(stage.fleet.resumeRobot("r1", "Max"));
    assertTrue(stage.scriptedRobot("r1").isHeld());
    refuses = false;
    HallFleetTest.accepted(stage.fleet.resumeRobot("r1", "Max"));
    stage.await(view -> !stage.scriptedRobot("r1").isHeld());
  }

  @Test
  void theSameOfATask() throws Exception {
    long id = HallFleetTest.accepted(stage.fleet.submit(HallFleetTest.order(1), "Clara")).id();
    stage.await(
        view ->
            view.tasks().stream().anyMatch(t -> t.id() == id && t.state() == TaskState.TO_OBJECT));
    refuses = true;
    assertRefused(stage.fleet.commandTask(id, new MissionEvent.Hold("Max")));
  }

  private static <T> void assertRefused(CompletionStage<Answer<T>> answer) {
    ExecutionException failure =
        assertThrows(
            ExecutionException.class, () -> answer.toCompletableFuture().get(10, TimeUnit.SECONDS));
    StoreException refusal = assertInstanceOf(StoreException.class, failure.getCause());
    assertEquals(List.of("too long", true), List.of(refusal.getMessage(), refusal.isRefusal()));
  }
}
