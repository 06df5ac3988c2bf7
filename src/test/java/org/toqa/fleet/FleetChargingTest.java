package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.toqa.fleet.HallFleetTest.accepted;
import static org.toqa.fleet.HallFleetTest.robot;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.mission.MissionEvent;
import org.toqa.wording.Sentence;

/** Two robots with low batteries and one charging point. */
@Timeout(60)
class FleetChargingTest {
  private static final Vec2 CHARGER = new Vec2(12.5, 0.5);
  private static final Where AWAY = new Where.Station("West");

  private static final FloorMap FLOOR =
      new FloorMap(
          "hall",
          HallFleetTest.GRID,
          HallFleetTest.FLOOR.stations(),
          HallFleetTest.FLOOR.parking(),
          List.of(new Place("C1", CHARGER)));

  private final FleetStage stage = new FleetStage(FLOOR);

  @AfterEach
  void stop() {
    stage.close();
  }

  /** It had been stopped as soon as it set out, and set out anew each few seconds. */
  @Test
  void whoWaitsForAChargerDrivesHomeInOneGo() throws Exception {
    stage.add("r1", CHARGER, "P1");
    stage.add("r2", new Vec2(14.5, 2.5), "P2");
    stage.restart();
    stage.scriptedRobot("r1").setBattery(0.1);
    stage.scriptedRobot("r2").setBattery(0.15);
    stage.await(
        view -> robot(view, "r2").work().doing().english().startsWith("Waiting for charger C1"));

    List<RobotState> states = new ArrayList<>();
    stage.await(
        view -> {
          RobotView waiting = robot(view, "r2");
          if (states.isEmpty() || states.getLast() != waiting.state()) {
            states.add(waiting.state());
          }
          return isHome(waiting) && waiting.state() == RobotState.IDLE;
        });

    assertEquals(List.of(RobotState.IDLE, RobotState.DRIVING, RobotState.IDLE), states);
  }

  /** It had kept the empty charger for itself until it was let go on, or empty. */
  @Test
  void whoIsOnHoldElsewhereKeepsNoCharger() throws Exception {
    begin();
    accepted(stage.fleet.holdRobot("r1", "Max"));
    stage.scriptedRobot("r1").setBattery(0.1);
    stage.await(view -> "C1".equals(robot(view, "r1").work().charger()));

    stage.scriptedRobot("r2").setBattery(0.15);
    stage.await(view -> robot(view, "r2").state() == RobotState.CHARGING);
    stage.scriptedRobot("r2").setBattery(0.7); // what it leaves for others with
    stage.pass(Duration.ofSeconds(5));
    assertEquals(RobotState.CHARGING, robot(latest(), "r2").state());
    accepted(stage.fleet.resumeRobot("r1", "Max"));

    stage.await(view -> robot(view, "r1").state() == RobotState.CHARGING);
    assertNull(robot(latest(), "r2").work().charger());
  }

  @Test
  void aRobotWhoseTaskIsOnHoldKeepsNoCharger() throws Exception {
    begin();
    stage.scriptedRobot("r1").setStuck(true);
    TaskOrder charge =
        new TaskOrder("charge", 0, AWAY, AWAY, null, 0, null, null, List.of("r1"), List.of())
            .along(List.of(new StopOrder(new Where.Charger("C1"), false, null, 1.0)));
    long task = accepted(stage.fleet.submit(charge, "Clara")).id();
    stage.await(view -> "C1".equals(robot(view, "r1").work().charger()));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Max")));
    stage.scriptedRobot("r1").setBattery(0.1);

    stage.scriptedRobot("r2").setBattery(0.15);
    stage.await(view -> robot(view, "r2").state() == RobotState.CHARGING);
  }

  @Test
  void whoIsDrivenByHandElsewhereKeepsNoCharger() throws Exception {
    begin();
    stage.scriptedRobot("r1").setBattery(0.1);
    stage.scriptedRobot("r2").setBattery(0.15);
    var asked = stage.fleet.driveByHand("r1", new ManualOrder(null, 1, 0, 0), "Ana");
    stage.awaitQuiescence();
    ManualAnswer hand = accepted(asked);

    AtomicLong number = new AtomicLong(1);
    stage.await(
        view -> {
          var _ =
              stage.fleet.driveByHand(
                  "r1", new ManualOrder(hand.lease(), number.incrementAndGet(), 0, 0), "Ana");
          return robot(view, "r2").state() == RobotState.CHARGING;
        });
    assertEquals("Ana", robot(latest(), "r1").work().driver());
  }

  /** It had run empty without a word. */
  @Test
  void whoWaitsWithALoadCallsAPersonBeforeItsBatteryIsEmpty() throws Exception {
    begin();
    Where middle = new Where.Point(new Vec2(6.5, 2.5));
    TaskOrder order =
        HallFleetTest.order(1)
            .along(
                List.of(
                    new StopOrder(AWAY, false, null),
                    new StopOrder(middle, true, null),
                    new StopOrder(AWAY, false, null)));
    long task = accepted(stage.fleet.submit(order, "Clara")).id();
    stage.await(view -> view.tasks().stream().anyMatch(t -> t.id() == task && t.isWaitingAtStop()));
    assertNull(alert());
    stage.scriptedRobot("r1").setBattery(0.2);
    stage.pass(Duration.ofSeconds(5));
    assertNull(alert());

    stage.scriptedRobot("r1").setBattery(0.06);
    stage.await(view -> alert() != null);
    assertEquals(
        "Has 6 %, which hardly lasts to deliver the load of task " + task + " and reach a charger",
        String.valueOf(alert()));
    accepted(stage.fleet.commandTask(task, new MissionEvent.GoOn("Clara", 1)));
    stage.await(view -> alert() == null);
    stage.scriptedRobot("r1").setBattery(0.005); // it needs 2 %
    stage.await(view -> alert() != null);
  }

  private @Nullable Sentence alert() {
    return robot(latest(), "r1").alert();
  }

  /** Both have what they need, and the charger is free. */
  private void begin() throws Exception {
    stage.add("r1", HallFleetTest.WEST, "P1");
    stage.add("r2", HallFleetTest.EAST, "P2");
    stage.restart();
    stage.scriptedRobot("r1").setBattery(0.9);
    stage.scriptedRobot("r2").setBattery(0.9);
    stage.await(view -> view.robots().stream().allMatch(robot -> robot.state() == RobotState.IDLE));
  }

  private FleetSnapshot latest() {
    return stage.fleet.snapshots().latest();
  }

  private static boolean isHome(RobotView robot) {
    Pose pose = robot.telemetry().pose();
    return pose != null && pose.position().distanceTo(HallFleetTest.EAST) < 0.05;
  }
}
