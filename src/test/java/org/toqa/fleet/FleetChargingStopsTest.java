package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.fleet.HallFleetTest.accepted;
import static org.toqa.fleet.HallFleetTest.answer;
import static org.toqa.fleet.HallFleetTest.robot;
import static org.toqa.fleet.HallFleetTest.task;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;

/** Tasks with stops at which their robot charges. */
@Timeout(60)
class FleetChargingStopsTest {
  private static final Where WEST = new Where.Station("West");
  private static final Where EAST = new Where.Station("East");

  private static final FloorMap FLOOR =
      new FloorMap(
          "hall",
          HallFleetTest.GRID,
          HallFleetTest.FLOOR.stations(),
          HallFleetTest.FLOOR.parking(),
          List.of(new Place("C1", new Vec2(12.5, 0.5)), new Place("C2", new Vec2(2.5, 2.5))));

  private final FleetStage stage = new FleetStage(FLOOR);

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void aLoadWaitsWhileItsRobotChargesAndGoesOnAlsoAfterRestarts() throws Exception {
    start("r1");
    stage.scriptedRobot("r1").setBattery(0.5);
    long task = submit(transport(stop(WEST), charge("C1", 0.8, null), stop(EAST)));
    stage.await(view -> task(view, task).isWaitingAtStop());
    assertEquals(
        "r1 charges at charger C1 until it has 80 %.",
        String.valueOf(task(latest(), task).waitingFor()));
    stage.restart();
    stage.await(view -> robot(view, "r1").state() == RobotState.CHARGING);
    assertEquals("Charging at C1", robot(latest(), "r1").work().doing().english());
    assertEquals(TaskState.CARRYING, task(latest(), task).state());

    stage.scriptedRobot("r1").setBattery(0.81);
    stage.await(view -> task(view, task).progress().stop() == 2);
    stage.restart();
    stage.await(view -> task(view, task).state() == TaskState.DONE);

    assertEquals(
        List.of(
            "Charges at charger C1",
            "Charged to 81 % at charger C1",
            "Leaves charger C1, stop 2 of 3",
            "Delivered at East"),
        said(task, "task.at-stop", "task.went-on", "task.delivered"));
    assertEquals(
        List.of("r1 is driving to charger C1: task " + task + " says so"),
        said(task, "robot.to-charger"));
  }

  @Test
  void theChargingIsPartOfWhenALoadIsExpected() throws Exception {
    start("r1");
    stage.scriptedRobot("r1").setBattery(0.5);
    long task = submit(transport(stop(WEST), charge("C1", 0.8, null), stop(EAST)));
    // from 50 % to 80 %, before the drives of some 20 m
    double charging = 0.3 * ChargingRules.USUAL.toFull().toSeconds();

    stage.await(view -> delivery(view, task) != null);
    double ordered = Duration.between(stage.now, delivery(latest(), task)).toSeconds();
    assertTrue(ordered > 0.9 * charging && ordered < 1.1 * charging + 120, () -> "in " + ordered);
    stage.await(view -> task(view, task).isWaitingAtStop());
    stage.scriptedRobot("r1").setBattery(0.75);
    stage.await(
        view -> {
          Instant told = delivery(view, task);
          return told != null
              && Duration.between(stage.now, told).toSeconds() < 0.06 * charging / 0.3 + 120;
        });
  }

  private static @Nullable Instant delivery(FleetSnapshot view, long task) {
    ExpectedTimes times = task(view, task).expected();
    return times == null ? null : times.delivery();
  }

  @Test
  void aRobotThatChoosesItsChargerTakesTheOneThatIsFreeSooner() throws Exception {
    start("r1", "r2");
    stage.scriptedRobot("r1").setBattery(0.6);
    stage.scriptedRobot("r2").setBattery(0.5);
    long first = submit(drive("r1", charge(null, null, Duration.ofMinutes(5))));
    stage.await(view -> robot(view, "r1").state() == RobotState.CHARGING);
    assertEquals("C2", robot(latest(), "r1").work().charger());
    long second = submit(drive("r2", charge("C2", 0.9, null)));
    stage.await(
        view ->
            String.valueOf(task(view, second).waitingFor())
                .equals("Waiting for charger C2, occupied by r1"));

    stage.await(view -> task(view, first).state() == TaskState.DONE); // five minutes
    stage.await(view -> robot(view, "r2").state() == RobotState.CHARGING);
    accepted(stage.fleet.commandTask(second, new MissionEvent.GoOn("Clara", 0)));
    stage.await(view -> task(view, second).state() == TaskState.DONE);
    assertNull(robot(latest(), "r2").work().charger());
    assertEquals(List.of("r1 has charged at C2: 60 %"), said(first, "robot.charged"));
  }

  @Test
  void whatWasCancelledChargesNoMore() throws Exception {
    start("r1");
    stage.scriptedRobot("r1").setBattery(0.5);
    long task = submit(drive("r1", charge(null, 1.0, null)));
    stage.await(view -> task(view, task).isWaitingAtStop());
    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Clara", null)));
    stage.await(view -> robot(view, "r1").work().charger() == null);
    stage.await(view -> robot(view, "r1").state() == RobotState.IDLE);
    assertEquals(TaskState.CANCELLED, task(latest(), task).state());
  }

  @Test
  void aChargerThatIsNotThereIsRefusedAtItsStop() throws Exception {
    start("r1");
    Answer<TaskView> refused =
        answer(
            stage.fleet.submit(
                transport(stop(WEST), charge("C9", 0.8, null), stop(EAST)), "Clara"));
    assertTrue(refused instanceof Answer.Rejected<TaskView>, refused::toString);
    Answer.Rejected<TaskView> rejected = (Answer.Rejected<TaskView>) refused;
    assertEquals("stops.1", rejected.field());
    assertEquals("There is no charger C9. Available: C1, C2.", rejected.sentence().english());
  }

  private void start(String... names) {
    for (int i = 0; i < names.length; i++) {
      stage.add(names[i], i == 0 ? HallFleetTest.WEST : HallFleetTest.EAST, "P" + (i + 1));
    }
    stage.restart();
  }

  private FleetSnapshot latest() {
    return stage.fleet.snapshots().latest();
  }

  private List<String> said(long task, String... kinds) {
    return stage.store.history(task).stream()
        .filter(event -> List.of(kinds).contains(event.kind()))
        .map(EventRecord::text)
        .toList();
  }

  private long submit(TaskOrder order) throws Exception {
    long id = accepted(stage.fleet.submit(order, "Clara")).id();
    stage.await(view -> view.tasks().stream().anyMatch(t -> t.id() == id));
    return id;
  }

  private static TaskOrder transport(StopOrder... stops) {
    return HallFleetTest.order(1).along(List.of(stops));
  }

  private static TaskOrder drive(String robot, StopOrder... stops) {
    return new TaskOrder("charge", 0, WEST, WEST, null, 0, null, null, List.of(robot), List.of())
        .along(List.of(stops));
  }

  private static StopOrder stop(Where where) {
    return new StopOrder(where, false, null);
  }

  private static StopOrder charge(
      @Nullable String charger, @Nullable Double until, @Nullable Duration time) {
    return new StopOrder(new Where.Charger(charger), false, time, until);
  }
}
