package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorDrawing;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.wording.Sentence;

/** What a server that starts knows of robots that it does not hear. */
class FleetRestartTest extends HallFleetTest {
  private static final double BODIES = 0.255; // metres from middle to middle where two touch

  @Test
  void aSilentRobotKeepsItsPlace() throws Exception {
    reopenWith("r2", DOOR, null);
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    scriptedRobot("r2").loseConnection();

    stage.restart();

    until(view -> robot(view, "r2").telemetry().pose() != null);
    assertEquals(RobotState.CONNECTING, robot(stage.fleet.snapshots().latest(), "r2").state());
    assertEquals(Map.of("r2", cells(new Cell(4, 1))), silentRobotCells());
    long task = submit("West", "East");
    until(view -> waitReason(view, task).startsWith("Waiting for r2"));
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    until(view -> task(view, task).state() == TaskState.DONE);

    stage.restart();

    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    assertNull(robot(stage.fleet.snapshots().latest(), "r2").telemetry().pose());
    assertEquals(Map.of(), silentRobotCells());
  }

  @Test
  void aRobotThatWasSaidToBeGoneAndIsHeardAgainHasItsPlaceAgain() throws Exception {
    reopenWith("r2", DOOR, null);
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    scriptedRobot("r2").fallSilent();
    until(view -> robot(view, "r2").state() == RobotState.LOST);
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    until(view -> robot(view, "r2").telemetry().pose() == null);
    scriptedRobot("r2").speakAgain();
    until(view -> robot(view, "r2").telemetry().pose() != null);
    scriptedRobot("r2").loseConnection();

    stage.restart();

    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    assertEquals(Map.of("r2", cells(new Cell(4, 1))), silentRobotCells());
  }

  @Test
  void aRobotThatBrokeDownAtAStationIsNotDrivenInto() throws Exception {
    reopenWith("r2", new Vec2(9.5, 2.5), null); // without parking: it stays at the station
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long first = submit(IN_THE_MIDDLE, new TaskOrder.Where.Station("East"));
    until(view -> task(view, first).state() == TaskState.DONE);
    assertEquals(0, scriptedRobot("r2").position().distanceTo(new Vec2(8.5, 2.5)), 0.2);
    scriptedRobot("r2").breakDown("SWITCH");
    until(view -> robot(view, "r2").state() == RobotState.ERROR);
    scriptedRobot("r2").loseConnection();

    stage.restart();

    long second = submit("West", "East");
    until(
        view -> {
          assertApart("r1", "r2");
          return task(view, second).state() == TaskState.CARRYING
              && waitReason(view, second).startsWith("Waiting for r2");
        });
    scriptedRobot("r2").repair();
    scriptedRobot("r2").speakAgain();
    until(
        view -> {
          assertApart("r1", "r2");
          return task(view, second).state() == TaskState.DONE;
        });
  }

  @Test
  void allThatASilentRobotMayDriveStaysReserved() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long first = submit("West", "East");
    untilCarryingOnTheWay(first);
    scriptedRobot("r1").loseConnection();

    stage.restart();

    until(view -> robot(view, "r1").telemetry().pose() != null);
    assertNotNull(silentRobotCells().get("r1"));
    long second = submit(IN_THE_MIDDLE, new TaskOrder.Where.Station("West"));
    until(
        view -> {
          assertApart("r1", "r2");
          return waitReason(view, second).startsWith("Waiting for r1");
        });
    scriptedRobot("r1").speakAgain();
    until(
        view -> {
          assertApart("r1", "r2");
          return task(view, first).state() == TaskState.DONE
              && task(view, second).state() == TaskState.DONE;
        });
  }

  /** Wider than they were, the two have no places beside the wall; each alone would get there. */
  @Test
  void aGroupThatHasNoRoomRoundItsLoadAnyMoreIsNotDrivenOntoIt() throws Exception {
    Vec2 load = new Vec2(5.5, 1.5);
    stage.add("r2", new Vec2(8.5, 1.5), null);
    reopenWith("r3", new Vec2(11.5, 1.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    for (String name : List.of("r2", "r3")) {
      scriptedRobot(name).setStuck(true);
    }
    long task =
        submit(
            new TaskOrder(
                "plate",
                8,
                new TaskOrder.Where.Point(load),
                new TaskOrder.Where.Point(new Vec2(12.5, 1.5)),
                null,
                0,
                null,
                null));
    until(view -> task(view, task).state() == TaskState.TO_OBJECT);
    for (String name : List.of("r2", "r3")) {
      scriptedRobot(name).setFootprint(1.2);
      scriptedRobot(name).setStuck(false);
    }
    stage.database.jdbi().useHandle(h -> h.execute("update places set diameter = 1.2"));

    stage.restart();

    until(view -> !waitReason(view, task).isEmpty());
    Instant end = stage.fleet.snapshots().latest().at().plusSeconds(60);
    until(
        view -> {
          for (String name : List.of("r2", "r3")) {
            double metres = scriptedRobot(name).position().distanceTo(load);
            assertTrue(metres > 0.9, () -> name + " is " + metres + " m from the load");
          }
          return view.at().isAfter(end);
        });
    assertEquals(
        "It needs 2 robots together; there is no room for them around the load at (5.50, 1.50),"
            + " or no path for them to (12.50, 1.50).",
        waitReason(stage.fleet.snapshots().latest(), task));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null)));
    until(
        view ->
            task(view, task).state() == TaskState.CANCELLED
                && robot(view, "r2").state() == RobotState.IDLE
                && robot(view, "r3").state() == RobotState.IDLE);
  }

  private Map<String, CellRuns> silentRobotCells() {
    return stage.fleet.snapshots().latest().floors().getFirst().silentRobotCells();
  }

  @Test
  void robotsAndTasksOfAFloorWhoseMapHasAnotherNameAreTold() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    long task = submit("West", "East");
    stage.database.jdbi().useHandle(h -> h.execute("update tasks set floor = 'old hall'"));

    stage.restart();

    FleetHealthTest.await(() -> alerts().anyMatch(FleetRestartTest::isOfOldHall));
    Answer<TaskView> refused =
        stage
            .fleet
            .commandTask(task, new MissionEvent.Cancel("Max", null))
            .toCompletableFuture()
            .get(10, TimeUnit.SECONDS);
    assertTrue(
        refused instanceof Answer.Conflict<TaskView>(Sentence why, var _)
            && isOfOldHall(why.english()),
        refused::toString);

    stage
        .fleet
        .floorEditing()
        .addFloor(
            "old hall", FloorDrawing.of(stage.fleet.floors().getFirst().drawing().walls()), "Max")
        .toCompletableFuture()
        .get(10, TimeUnit.SECONDS);
    FleetHealthTest.await(() -> alerts().findAny().isEmpty());
    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null)));
    until(view -> task(view, task).state() == TaskState.CANCELLED);
  }

  private Stream<String> alerts() {
    return stage.fleet.snapshots().latest().alerts().stream().map(Sentence::english);
  }

  private static boolean isOfOldHall(String sentence) {
    return sentence.equals(
        "No floor is named old hall any more; its robots (0) and open tasks (1) are left behind:"
            + " add a floor of that name on the page Floors");
  }

  private void assertApart(String one, String other) {
    double apart = scriptedRobot(one).position().distanceTo(scriptedRobot(other).position());
    assertTrue(apart > BODIES, () -> one + " and " + other + " are " + apart + " m apart");
  }
}
