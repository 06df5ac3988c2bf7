package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.ServerMessage;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;

/** What is stopped and let go on while the store is slow or away. */
class FleetStopTest extends HallFleetTest {
  private static final Duration A_WHILE = Duration.ofSeconds(5);

  @Test
  void aPausePressedWhileAResumeIsBeingStoredWins() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    accepted(stage.fleet.pauseAll("Max"));
    until(view -> scriptedRobot("r1").isHeld());
    stopStore();
    CompletionStage<Answer<Optional<Hold>>> resume = stage.fleet.resumeAll("Boss");
    CompletionStage<Answer<Optional<Hold>>> pause = stage.fleet.pauseAll("Clara");
    stage.pass(A_WHILE);
    assertFalse(isAnswered(pause), "before it is stored");

    startStore();

    stage.pass(A_WHILE);
    assertEquals("Clara", accepted(pause).orElseThrow().user());
    accepted(resume);
    assertEquals("Clara", Objects.requireNonNull(stage.fleet.snapshots().latest().pause()).user());
    assertEquals("Clara", stage.store.pause().orElseThrow().user());
    assertTrue(scriptedRobot("r1").isHeld());
    accepted(stage.fleet.resumeAll("Boss"));
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aFloorHeldWhileItsResumeIsBeingStoredStaysHeld() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    accepted(stage.fleet.holdFloor("hall", "Max"));
    until(view -> scriptedRobot("r1").isHeld());
    stopStore();
    CompletionStage<Answer<Optional<Hold>>> resume = stage.fleet.resumeFloor("hall", "Boss");
    CompletionStage<Answer<Optional<Hold>>> hold = stage.fleet.holdFloor("hall", "Clara");
    stage.awaitQuiescence();

    startStore();

    stage.pass(A_WHILE);
    accepted(resume);
    assertEquals("Clara", accepted(hold).orElseThrow().user());
    assertEquals(
        "Clara",
        Objects.requireNonNull(stage.fleet.snapshots().latest().floors().getFirst().hold()).user());
    assertEquals("Clara", Objects.requireNonNull(stage.store.floorHolds().get("hall")).user());
    assertTrue(scriptedRobot("r1").isHeld());
  }

  @Test
  void aResumeThatIsAskedForTwiceIsToldOnce() throws Exception {
    accepted(stage.fleet.pauseAll("Max"));
    stopStore();
    CompletionStage<Answer<Optional<Hold>>> one = stage.fleet.resumeAll("Boss");
    CompletionStage<Answer<Optional<Hold>>> other = stage.fleet.resumeAll("Boss");
    stage.awaitQuiescence();
    assertFalse(isAnswered(other), "before it is stored");

    startStore();

    assertEquals(Optional.empty(), accepted(one));
    assertEquals(Optional.empty(), accepted(other));
    assertEquals(1, history("fleet.resumed").size());
  }

  @Test
  void aResumeOfAFloorThatIsAskedForTwiceIsToldOnce() throws Exception {
    accepted(stage.fleet.holdFloor("hall", "Max"));
    stopStore();
    CompletionStage<Answer<Optional<Hold>>> one = stage.fleet.resumeFloor("hall", "Boss");
    CompletionStage<Answer<Optional<Hold>>> other = stage.fleet.resumeFloor("hall", "Boss");
    stage.awaitQuiescence();

    startStore();

    assertEquals(Optional.empty(), accepted(one));
    assertEquals(Optional.empty(), accepted(other));
    assertTrue(stage.store.floorHolds().isEmpty());
    assertEquals(1, history("floor.resumed").size());
  }

  @Test
  void aRobotIsHeldAtOnceAndGoesOnOnlyWhenThatIsStored() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    stopStore();
    CompletionStage<Answer<RobotView>> hold = stage.fleet.holdRobot("r1", "Max");
    until(view -> scriptedRobot("r1").isHeld());
    assertFalse(isAnswered(hold), "before it is stored");
    startStore();
    accepted(hold);
    stopStore();

    CompletionStage<Answer<RobotView>> resume = stage.fleet.resumeRobot("r1", "Max");

    stage.pass(A_WHILE);
    assertTrue(scriptedRobot("r1").isHeld());
    CompletionStage<Answer<RobotView>> heldAgain = stage.fleet.holdRobot("r1", "Clara");
    stage.awaitQuiescence();
    startStore();
    stage.pass(A_WHILE);
    accepted(resume);
    assertTrue(accepted(heldAgain).work().held());
    assertTrue(scriptedRobot("r1").isHeld());
    assertTrue(stage.store.storedRobots().getFirst().held());
    assertFalse(accepted(stage.fleet.resumeRobot("r1", "Max")).work().held());
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aTaskIsHeldAtOnceAndGoesOnOnlyWhenThatIsStored() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    stopStore();
    CompletionStage<Answer<TaskView>> hold =
        stage.fleet.commandTask(task, new MissionEvent.Hold("Max"));
    until(view -> scriptedRobot("r1").isHeld());
    startStore();
    accepted(hold);
    stopStore();

    CompletionStage<Answer<TaskView>> resume =
        stage.fleet.commandTask(task, new MissionEvent.Resume("Max"));

    stage.pass(A_WHILE);
    assertTrue(scriptedRobot("r1").isHeld());
    startStore();
    accepted(resume);
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aTaskThatIsCancelledWhileTheStoreIsAwayStopsAtOnce() throws Exception {
    long task = submit("East", "West");
    until(
        view -> task(view, task).state() == TaskState.TO_OBJECT && scriptedRobot("r1").isDriving());
    stopStore();

    CompletionStage<Answer<TaskView>> cancel =
        stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null));

    stage.pass(Duration.ofMillis(300));
    assertFalse(scriptedRobot("r1").isDriving());
    Vec2 stopped = scriptedRobot("r1").position();
    stage.pass(Duration.ofMinutes(1));
    assertEquals(stopped, scriptedRobot("r1").position(), "nor does it go home before");
    startStore();
    assertEquals(TaskState.CANCELLED, accepted(cancel).state());
    until(view -> scriptedRobot("r1").position().distanceTo(WEST) < 1e-6);
  }

  @Test
  void aLoadThatIsToBeSetDownIsStoppedAtOnceAndNothingGoesOnBeforeThatIsStored() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    stopStore();

    CompletionStage<Answer<TaskView>> cancel =
        stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.HERE));

    stage.pass(Duration.ofMillis(300));
    assertFalse(scriptedRobot("r1").isDriving());
    Vec2 stopped = scriptedRobot("r1").position();
    stage.pass(Duration.ofMinutes(1));
    assertEquals(stopped, scriptedRobot("r1").position());
    startStore();
    accepted(cancel);
    until(view -> task(view, task).state() == TaskState.CANCELLED);
  }

  @Test
  void aFollowerIsToldItsPlaceOnlyWhenThePickUpIsStored() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submitForTwo();
    until(view -> task(view, task).state() == TaskState.TO_OBJECT);
    stage.stopStoreFor(agent -> agent.startsWith("floor"));

    until(view -> task(view, task).state() == TaskState.CARRYING);
    stage.pass(A_WHILE);

    assertEquals(TaskState.TO_OBJECT, stage.store.task(task).orElseThrow().state());
    assertFalse(hasFollow("r1") || hasFollow("r2"));
    startStore();
    until(view -> hasFollow("r1") || hasFollow("r2"));
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aGroupWhoseFollowerDoesNotFollowSaysSo() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    scriptedRobot("r1").stay();
    scriptedRobot("r2").stay();
    long task = submitForTwo();
    until(view -> task(view, task).state() == TaskState.CARRYING);
    stage.pass(A_WHILE);

    until(view -> waitReason(view, task).contains("with the load: look what stops r"));
  }

  /** A load that is too heavy for one. */
  private long submitForTwo() throws Exception {
    return submit(
        new TaskOrder(
            "box",
            8,
            new TaskOrder.Where.Point(new Vec2(7, 1.5)),
            new TaskOrder.Where.Point(new Vec2(12, 1.5)),
            null,
            0,
            null,
            null));
  }

  private boolean hasFollow(String robot) {
    return scriptedRobot(robot).obeyed().stream().anyMatch(ServerMessage.Follow.class::isInstance);
  }

  private void stopStore() {
    stage.stopStoreFor(agent -> true);
  }

  private void startStore() throws InterruptedException {
    stage.startStore();
    stage.awaitQuiescence();
  }

  private static boolean isAnswered(CompletionStage<?> answer) {
    return ((CompletableFuture<?>) answer.toCompletableFuture()).isDone();
  }
}
