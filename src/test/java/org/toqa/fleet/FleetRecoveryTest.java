package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.link.message.ServerMessage;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Reply;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;

/** Robots that are lost or fail: what becomes of their cells, their tasks and their loads. */
class FleetRecoveryTest extends HallFleetTest {
  @Test
  void aLostRobotKeepsItsCellsUntilAPersonSaysThatItIsGone() throws Exception {
    reopenWith("r2", DOOR, null);
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    scriptedRobot("r2").fallSilent();
    until(view -> robot(view, "r2").state() == RobotState.LOST);
    assertEquals(
        Map.of("r2", cells(new Cell(4, 1))),
        stage.fleet.snapshots().latest().floors().getFirst().silentRobotCells());
    long task = submit("West", "East");
    until(view -> waitReason(view, task).startsWith("Waiting for r2"));

    RobotView taken = accepted(stage.fleet.takeOutOfService("r2", "Max"));

    assertEquals(RobotState.OUT_OF_SERVICE, taken.state());
    assertNull(taken.telemetry().pose());
    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(Map.of(), stage.fleet.snapshots().latest().floors().getFirst().silentRobotCells());
    assertEquals(
        List.of("Max took r2 out of service and released its place"),
        history("robot.out-of-service"));
  }

  @Test
  void aRobotThatIsHeardAgainAfterItWasSaidToBeGoneHasItsPlaceAgain() throws Exception {
    reopenWith("r2", DOOR, null);
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    scriptedRobot("r2").fallSilent();
    until(view -> robot(view, "r2").state() == RobotState.LOST);
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    scriptedRobot("r2").speakAgain();
    until(view -> robot(view, "r2").telemetry().pose() != null);

    long task = submit("West", "East");

    until(view -> waitReason(view, task).startsWith("Waiting for r2"));
    assertEquals(RobotState.OUT_OF_SERVICE, robot(stage.fleet.snapshots().latest(), "r2").state());
  }

  @Test
  void aRobotOutOfServiceThatFallsSilentKeepsItsPlaceUntilAPersonSaysItAgain() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    scriptedRobot("r1").fallSilent();
    until(view -> view.floors().getFirst().silentRobotCells().containsKey("r1"));

    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    until(view -> view.floors().getFirst().silentRobotCells().isEmpty());
    assertEquals(
        List.of("Max took r1 out of service", "Max took r1 out of service and released its place"),
        history("robot.out-of-service"));
  }

  @Test
  void theTaskOfARobotThatFailsBeforeThePickUpGoesToAnotherAtOnce() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit(IN_THE_MIDDLE, new Where.Station("West"));
    until(view -> task(view, task).robots().equals(List.of("r1")));

    scriptedRobot("r1").breakDown("BUMPER");

    until(view -> task(view, task).robots().equals(List.of("r2")));
    assertTrue(
        history("task.robot-failed")
            .contains("r1 reports the error BUMPER; looking for another robot"));
  }

  @Test
  void aLostRobotsTaskWaitsThenGoesToAnotherAndTheLostOneIsCancelledFirst() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit(IN_THE_MIDDLE, new Where.Station("West"));
    until(
        view -> task(view, task).state() == TaskState.TO_OBJECT && scriptedRobot("r1").isDriving());
    scriptedRobot("r1").loseConnection();
    Instant lost = stage.now;
    until(view -> task(view, task).needs() != null);
    assertEquals(
        List.of("another robot", "wait"),
        Objects.requireNonNull(task(stage.fleet.snapshots().latest(), task).needs()).answers());

    until(view -> task(view, task).robots().equals(List.of("r2")));

    assertTrue(!stage.now.isBefore(lost.plus(FleetStage.REASSIGN_AFTER)), "not before 30 s");
    assertTrue(
        stage.fleet.snapshots().latest().floors().getFirst().silentRobotCells().containsKey("r1"));
    int told = scriptedRobot("r1").obeyed().size();
    scriptedRobot("r1").speakAgain();
    until(view -> scriptedRobot("r1").obeyed().size() > told);
    assertInstanceOf(ServerMessage.Cancel.class, scriptedRobot("r1").obeyed().get(told));
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aLostRobotsTaskGoesToAnotherAtOnceByAPersonsWord() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit(IN_THE_MIDDLE, new Where.Station("West"));
    until(view -> task(view, task).robots().equals(List.of("r1")));
    scriptedRobot("r1").fallSilent();
    Instant lost = stage.now;
    until(view -> task(view, task).needs() != null);

    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.ANOTHER)));

    until(view -> task(view, task).robots().equals(List.of("r2")));
    assertTrue(
        stage.now.isBefore(lost.plus(FleetStage.REASSIGN_AFTER)), "before the 30 s are over");
  }

  @Test
  void aRobotThatFailsWithTheLoadLetsAPersonDecideAndAnotherFetchesIt() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    scriptedRobot("r1").breakDown("BUMPER");
    until(view -> task(view, task).needs() != null);
    Vec2 place =
        Objects.requireNonNull(task(stage.fleet.snapshots().latest(), task).loadAt()).position();
    assertEquals(scriptedRobot("r1").position(), place);
    stage.restart(); // the question survives a restart
    until(view -> !view.tasks().isEmpty() && task(view, task).needs() != null);

    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.ANOTHER)));
    until(view -> task(view, task).robots().equals(List.of("r2")));
    scriptedRobot("r1").fallSilent(); // it is carried away
    until(view -> robot(view, "r1").state() == RobotState.LOST);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    until(view -> task(view, task).state() == TaskState.CARRYING);
    until(view -> task(view, task).state() == TaskState.DONE);
    assertTrue(
        stage.store.history(task).stream()
            .anyMatch(e -> e.text().equals("Picked up at " + new TaskPlace(place, null).text())));
  }

  @Test
  void aRobotThatFailsWithTheLoadAndIsMendedGoesOn() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    scriptedRobot("r1").breakDown("BUMPER");
    until(view -> task(view, task).needs() != null);
    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.WAIT)));
    until(view -> task(view, task).needs() == null);

    scriptedRobot("r1").repair();

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of("r1 can continue"), history("task.robot-back"));
  }

  @Test
  void aRobotThatFailsOnItsWayHomeHasDoneItsTask() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.RETURNING && scriptedRobot("r1").isDriving());

    scriptedRobot("r1").breakDown("BUMPER");

    until(view -> task(view, task).state() == TaskState.DONE);
    assertTrue(scriptedRobot("r1").position().distanceTo(WEST) > 0.5, "it did not get home");
  }
}
