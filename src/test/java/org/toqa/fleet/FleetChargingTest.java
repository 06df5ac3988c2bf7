package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.toqa.fleet.HallFleetTest.robot;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;

/** Two robots with low batteries and one charging point. */
@Timeout(60)
class FleetChargingTest {
  private static final Vec2 CHARGER = new Vec2(12.5, 0.5);

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

  private static boolean isHome(RobotView robot) {
    Pose pose = robot.telemetry().pose();
    return pose != null && pose.position().distanceTo(HallFleetTest.EAST) < 0.05;
  }
}
