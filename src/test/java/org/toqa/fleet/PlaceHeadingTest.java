package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;

/** A robot stands at a place as that says. */
class PlaceHeadingTest {
  private static final double NORTH = Math.PI / 2;

  private final FleetStage stage =
      new FleetStage(
          new FloorMap(
              "hall",
              HallFleetTest.GRID,
              List.of(
                  new Place("West", new Vec2(0.5, 2.5)),
                  new Place("East", new Vec2(8.5, 2.5), NORTH, null)),
              List.of(new Place("P1", HallFleetTest.WEST, -NORTH, null)),
              List.of()));

  @Test
  void aRobotTurnsThereBeforeItsDriveEnds() throws Exception {
    try (stage) {
      stage.add("r1", HallFleetTest.WEST, "P1");
      stage.restart();
      var order = HallFleetTest.order(1);
      long task = HallFleetTest.accepted(stage.fleet.submit(order, "Clara")).id();
      boolean[] facedNorth = new boolean[1];
      stage.await(
          view -> {
            RobotView robot = HallFleetTest.robot(view, "r1");
            Pose pose = robot.telemetry().pose();
            facedNorth[0] |=
                pose != null
                    && pose.position().distanceTo(new Vec2(8.5, 2.5)) < 0.01
                    && Math.abs(pose.theta() - NORTH) < 0.01;
            return view.tasks().stream()
                .anyMatch(t -> t.id() == task && t.state() == TaskState.DONE);
          });
      stage.await(view -> HallFleetTest.robot(view, "r1").state() == RobotState.IDLE);
      Pose parked =
          Objects.requireNonNull(
              HallFleetTest.robot(stage.fleet.snapshots().latest(), "r1").telemetry().pose());

      assertTrue(facedNorth[0]);
      assertEquals(0, parked.position().distanceTo(HallFleetTest.WEST), 0.1);
      assertEquals(-NORTH, parked.theta(), 0.05);
    }
  }
}
