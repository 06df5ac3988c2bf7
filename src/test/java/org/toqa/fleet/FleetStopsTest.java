package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Reply;
import org.toqa.mission.StopState;
import org.toqa.mission.TaskState;

/** Tasks along several stops, at which robots wait for a person or a time. */
class FleetStopsTest extends HallFleetTest {
  private static final Where WEST_STATION = new Where.Station("West");
  private static final Where EAST_STATION = new Where.Station("East");
  private static final Where BEYOND = new Where.Point(new Vec2(8.5, 2.5));

  @Test
  void aTourGoesOnFromEveryStopAlsoAfterRestarts() throws Exception {
    long task =
        submit(
            tour(
                stop(WEST_STATION),
                new StopOrder(IN_THE_MIDDLE, true, null),
                new StopOrder(EAST_STATION, false, Duration.ofSeconds(1)),
                stop(WEST_STATION)));
    until(view -> task(view, task).isWaitingAtStop());
    stage.restart();
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    TaskView waiting = task(stage.fleet.snapshots().latest(), task);
    assertEquals(
        "r1 waits at (6.50, 2.50) until somebody says “Go on”.",
        String.valueOf(waiting.waitingFor()));
    assertEquals(
        List.of(StopState.PASSED, StopState.HERE, StopState.AHEAD, StopState.AHEAD),
        waiting.stops().stream().map(TaskView.StopView::state).toList());
    assertInstanceOf(
        Answer.Conflict.class,
        answer(stage.fleet.commandTask(task, new MissionEvent.GoOn("Clara", 0))));

    accepted(stage.fleet.commandTask(task, new MissionEvent.GoOn("Clara", 1)));
    stage.restart(); // right after the answer
    until(view -> task(view, task).progress().stop() == 3);
    stage.restart();
    until(view -> task(view, task).state() == TaskState.DONE);

    assertEquals(
        List.of(
            "Waits at (6.50, 2.50)",
            "Clara let the robot go on from (6.50, 2.50)",
            "Leaves (6.50, 2.50), stop 2 of 4",
            "Waits at East",
            "The time to wait at East is over",
            "Leaves East, stop 3 of 4",
            "Delivered at West"),
        stage.store.history(task).stream()
            .filter(
                event ->
                    List.of("task.at-stop", "task.went-on", "task.delivered")
                        .contains(event.kind()))
            .map(EventRecord::text)
            .toList());
    assertEquals(1, history("task.delivered").size());
  }

  @Test
  void aClockThatIsSetNeitherEndsNorProlongsAWait() throws Exception {
    long task = submitTourWithAMinute();
    until(view -> task(view, task).isWaitingAtStop());

    stage.pass(Duration.ofSeconds(30));
    stage.setClock(Duration.ofDays(1));
    stage.pass(Duration.ofSeconds(25));
    assertTrue(task(stage.fleet.snapshots().latest(), task).isWaitingAtStop());
    stage.setClock(Duration.ofHours(-2));
    stage.pass(Duration.ofSeconds(10));
    assertFalse(task(stage.fleet.snapshots().latest(), task).isWaitingAtStop());
  }

  @Test
  void aWaitThatAccordingToTheClockHasNotBegunYetIsNoLongerThanOrdered() throws Exception {
    stage.setClock(Duration.ofDays(1));
    long task = submitTourWithAMinute();
    until(view -> task(view, task).isWaitingAtStop());

    stage.setClock(Duration.ZERO);
    stage.restart();
    stage.pass(Duration.ofSeconds(55));
    assertTrue(task(stage.fleet.snapshots().latest(), task).isWaitingAtStop());
    stage.pass(Duration.ofSeconds(10));
    assertFalse(task(stage.fleet.snapshots().latest(), task).isWaitingAtStop());
  }

  private long submitTourWithAMinute() throws Exception {
    return submit(
        tour(
            stop(WEST_STATION),
            new StopOrder(IN_THE_MIDDLE, false, Duration.ofMinutes(1)),
            stop(EAST_STATION)));
  }

  @Test
  void whoWaitsAtAStopCanBeHeldAndCancelled() throws Exception {
    long task = submit(tour(stop(WEST_STATION), new StopOrder(EAST_STATION, true, null)));
    until(view -> task(view, task).isWaitingAtStop());
    accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Clara")));
    assertInstanceOf(
        Answer.Conflict.class,
        answer(stage.fleet.commandTask(task, new MissionEvent.GoOn("Clara", null))));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Resume("Clara")));

    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Clara", LoadChoice.BACK)));
    until(view -> task(view, task).state() == TaskState.CANCELLED);

    assertEquals(List.of(), stage.fleet.snapshots().latest().floors().getFirst().leftLoads());
  }

  @Test
  void stopsThatCannotBeAreRefusedEachAtItsPlace() throws Exception {
    assertEquals(
        "stops.1",
        refusal(tour(stop(WEST_STATION), stop(new Where.Station("Moon")), stop(EAST_STATION))));
    assertEquals(
        "stops.2", refusal(tour(stop(WEST_STATION), stop(EAST_STATION), stop(EAST_STATION))));
  }

  @Test
  void severalRobotsCarryALoadAlongItsStopsAlsoAfterRestarts() throws Exception {
    TaskOrder heavy = orderForTwo();
    long task =
        submit(
            heavy.along(
                List.of(
                    stop(heavy.start()),
                    new StopOrder(BEYOND, true, null),
                    new StopOrder(heavy.goal(), false, Duration.ofSeconds(1)),
                    stop(heavy.start()))));
    until(view -> task(view, task).isWaitingAtStop());
    assertEquals(2, task(stage.fleet.snapshots().latest(), task).robots().size());
    stage.restart();
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    TaskView waiting = task(stage.fleet.snapshots().latest(), task);
    assertEquals(
        List.of(StopState.PASSED, StopState.HERE, StopState.AHEAD, StopState.AHEAD),
        waiting.stops().stream().map(TaskView.StopView::state).toList());

    accepted(stage.fleet.commandTask(task, new MissionEvent.GoOn("Clara", 1)));
    stage.restart();
    until(view -> task(view, task).progress().stop() == 2);
    accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Clara")));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Resume("Clara")));
    until(view -> task(view, task).progress().stop() == 3);
    stage.restart();
    until(view -> task(view, task).state() == TaskState.DONE);

    assertEquals(
        List.of(
            "Waits at (8.50, 2.50)",
            "Clara let the robot go on from (8.50, 2.50)",
            "Leaves (8.50, 2.50), stop 2 of 4",
            "Waits at (11.50, 1.50)",
            "The time to wait at (11.50, 1.50) is over",
            "Leaves (11.50, 1.50), stop 3 of 4",
            "Delivered at (6.50, 1.50)"),
        stage.store.history(task).stream()
            .filter(
                event ->
                    List.of("task.at-stop", "task.went-on", "task.delivered")
                        .contains(event.kind()))
            .map(EventRecord::text)
            .filter(text -> !text.matches("r[12] arrived at .*"))
            .toList());
    assertEquals(
        List.of(
            "r1 arrived at (8.50, 2.50)", "r1 arrived at (11.50, 1.50)", "r1 arrived at the goal"),
        stage.store.history(task).stream()
            .map(EventRecord::text)
            .filter(text -> text.startsWith("r1 arrived at"))
            .filter(text -> !text.endsWith("load"))
            .toList());
  }

  @Test
  void severalRobotsAtAStopSetTheLoadDownThere() throws Exception {
    TaskOrder heavy = orderForTwo();
    long task =
        submit(
            heavy.along(
                List.of(
                    stop(heavy.start()), new StopOrder(BEYOND, true, null), stop(heavy.goal()))));
    until(view -> task(view, task).isWaitingAtStop());

    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Clara", LoadChoice.HERE)));
    until(view -> task(view, task).state() == TaskState.CANCELLED);

    assertEquals(1, stage.fleet.snapshots().latest().floors().getFirst().leftLoads().size());
  }

  /** Where there is no room for others at a stop that the load has left. */
  @Test
  void aLoadThatWasSetDownBetweenStopsIsForAllWhoHaveRoomOnTheRestOfItsWay() throws Exception {
    stage.add("r3", new Vec2(2.5, 0.5), null).setFootprint(0.7);
    stage.add("r4", new Vec2(2.5, 2.5), null).setFootprint(0.7);
    TaskOrder heavy = orderForTwo();
    for (String robot : List.of("r3", "r4")) {
      accepted(stage.fleet.takeOutOfService(robot, "Max"));
    }
    Where end = new Where.Point(new Vec2(14.5, 0.5));
    Where middle = new Where.Point(new Vec2(9.5, 1.5));
    long task =
        submit(
            new TaskOrder("box", heavy.load(), middle, heavy.start(), null, 0, null, null)
                .along(
                    List.of(
                        stop(middle),
                        stop(end),
                        new StopOrder(middle, true, null),
                        stop(heavy.start()))));
    until(view -> task(view, task).progress().stop() == 2);
    until(view -> scriptedRobot("r1").isDriving() && scriptedRobot("r1").position().x() < 12.5);
    assertEquals(
        Set.of("r1", "r2"), Set.copyOf(task(stage.fleet.snapshots().latest(), task).robots()));
    scriptedRobot("r1").breakDown("BUMPER");
    until(view -> task(view, task).needs() != null);
    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.ANOTHER)));
    for (String robot : List.of("r1", "r2")) {
      scriptedRobot(robot).fallSilent(); // it is carried away
      until(view -> robot(view, robot).state() == RobotState.LOST);
      accepted(stage.fleet.takeOutOfService(robot, "Max"));
    }
    for (String robot : List.of("r3", "r4")) {
      accepted(stage.fleet.putInService(robot, "Max"));
    }

    until(view -> task(view, task).robots().size() == 2);
    until(view -> task(view, task).isWaitingAtStop());
    accepted(stage.fleet.commandTask(task, new MissionEvent.GoOn("Clara", 2)));
    until(view -> task(view, task).progress().stop() == 3);
    stage.restart();
    until(view -> !view.tasks().isEmpty());
    assertEquals(2, task(stage.fleet.snapshots().latest(), task).progress().fetchedBefore());
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void severalRobotsDoNotChargeOnTheWay() throws Exception {
    TaskOrder heavy = orderForTwo();
    assertEquals(
        "stops.1",
        refusal(
            heavy.along(
                List.of(
                    stop(heavy.start()),
                    new StopOrder(new Where.Charger(null), true, null),
                    stop(heavy.goal())))));
  }

  /** A load for r1 and r2 together. */
  private TaskOrder orderForTwo() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    return orderForSeveral(1.5 * robot(stage.fleet.snapshots().latest(), "r1").maxLoad());
  }

  @Test
  void aDriveWithoutALoadGoesWhereItShallAlsoAfterRestarts() throws Exception {
    long task =
        submit(
            drive(
                new StopOrder(EAST_STATION, true, null),
                stop(IN_THE_MIDDLE),
                new StopOrder(WEST_STATION, false, Duration.ofSeconds(1))));
    until(view -> robot(view, "r1").work().doing().english().equals("Driving for task " + task));
    until(view -> task(view, task).isWaitingAtStop());
    stage.restart();
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    FleetSnapshot waiting = stage.fleet.snapshots().latest();
    assertEquals(
        "r1 waits at East until somebody says “Go on”.",
        String.valueOf(task(waiting, task).waitingFor()));
    assertEquals(
        List.of(StopState.HERE, StopState.AHEAD, StopState.AHEAD),
        task(waiting, task).stops().stream().map(TaskView.StopView::state).toList());
    assertEquals(List.of(), LoadView.of(waiting));

    accepted(stage.fleet.commandTask(task, new MissionEvent.GoOn("Clara", 0)));
    stage.restart();
    until(view -> task(view, task).progress().stop() == 2);
    stage.restart();
    until(view -> task(view, task).state() == TaskState.DONE);

    assertEquals(
        List.of(
            "Waits at East",
            "Clara let the robot go on from East",
            "Leaves East, stop 1 of 3",
            "Leaves (6.50, 2.50), stop 2 of 3",
            "Waits at West",
            "The time to wait at West is over",
            "The drive ended at West"),
        stage.store.history(task).stream()
            .filter(event -> List.of("task.at-stop", "task.went-on").contains(event.kind()))
            .map(EventRecord::text)
            .toList());
  }

  @Test
  void aDriveToOnePlaceIsCancelledWithoutAQuestion() throws Exception {
    long task = submit(drive(new StopOrder(EAST_STATION, true, null)));
    until(view -> task(view, task).isWaitingAtStop());
    assertNotNull(task(stage.fleet.snapshots().latest(), task).stops().getFirst().since());
    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Clara", null)));
    until(view -> task(view, task).state() == TaskState.CANCELLED);

    long next = submit(drive(stop(EAST_STATION)));
    until(view -> task(view, next).state() == TaskState.DONE);
    assertEquals("stops.0", refusal(drive(stop(new Where.Station("Moon")))));
    assertEquals("stops.1", refusal(drive(stop(EAST_STATION), stop(EAST_STATION))));
  }

  @Test
  void thePreviewOfADriveBeginsWhereItsRobotIs() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    TaskPreview preview =
        accepted(stage.fleet.preview(drive(stop(EAST_STATION), stop(IN_THE_MIDDLE)), "Clara"));

    assertEquals(List.of("r1"), preview.chosen());
    assertTrue(preview.path().getFirst().distanceTo(WEST) < 0.8, preview::toString);
    assertTrue(preview.metres() > 10, preview::toString); // 8 m to East, and 2 m back
  }

  private static TaskOrder drive(StopOrder... stops) {
    return order(0).along(List.of(stops));
  }

  private static StopOrder stop(Where where) {
    return new StopOrder(where, false, null);
  }

  private static TaskOrder tour(StopOrder... stops) {
    return order(1).along(List.of(stops));
  }

  private String refusal(TaskOrder order) throws Exception {
    Answer<TaskView> answer = answer(stage.fleet.submit(order, "Clara"));
    assertTrue(answer instanceof Answer.Rejected<TaskView>, answer::toString);
    return String.valueOf(((Answer.Rejected<TaskView>) answer).field());
  }
}
