package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.floor.ObstacleMap;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.CellRuns;
import org.toqa.mission.TaskState;

/** What robots see on the floor, and how they drive round it. */
class FleetObstaclesTest extends HallFleetTest {
  @Test
  void anObstacleIsShownWhileItIsSeenAndAWhileLonger() throws Exception {
    scriptedRobot("r1").setObstacles(new Vec2(6.2, 1.1), new Vec2(6.8, 1.9), new Vec2(4.5, 0.5));

    until(view -> obstacles(view).equals(cells(new Cell(6, 1))));
    scriptedRobot("r1").setObstacles();
    Instant unseen = stage.now;
    until(view -> obstacles(view).equals(CellRuns.NONE));

    assertTrue(
        !stage.now.isBefore(unseen.plus(ObstacleMap.REMEMBER_FOR).minusMillis(200)),
        stage.now.toString());
    untilHistory(
        "floor.obstacle-gone",
        "The obstacle at (6.50, 1.50) is no longer detected; robots may drive there again");
    untilHistory(
        "floor.obstacle",
        "r1 detects something at (6.50, 1.50) that is not on the map; robots drive around it");
  }

  @Test
  void rangesThatComeBesideTheLinkAreSeenFromWhereTheRobotIs() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    Pose pose =
        Objects.requireNonNull(robot(stage.fleet.snapshots().latest(), "r1").telemetry().pose());
    RobotCapabilities able = robot(stage.fleet.snapshots().latest(), "r1").capabilities();
    Vec2 ahead = pose.compose(new Pose(able.footprint() / 2 + 0.5, 0, 0)).position(); // rim + 0.5 m

    double nothing = able.sensorRange();
    until(
        view -> {
          stage.fleet.tellRanges(
              "r1",
              List.of(0.5, nothing, nothing, nothing),
              List.of(0.0, Math.PI / 2, -Math.PI / 2, Math.PI));
          return obstacles(view).equals(cells(GRID.cellAt(ahead)));
        });
    Instant unseen = stage.now;
    until(view -> obstacles(view).equals(CellRuns.NONE));
    assertTrue(!stage.now.isBefore(unseen.plus(ObstacleMap.REMEMBER_FOR).minusMillis(700)));
  }

  @Test
  void whatARobotSeesWhereAnotherOneStandsIsNoObstacle() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> robot(view, "r2").state() == RobotState.IDLE);

    scriptedRobot("r1").setObstacles(EAST, new Vec2(6.5, 1.5));

    until(view -> !obstacles(view).equals(CellRuns.NONE));
    assertEquals(cells(new Cell(6, 1)), obstacles(stage.fleet.snapshots().latest()));
  }

  @Test
  void aDrivingRobotGoesRoundWhatAnotherOneSees() throws Exception {
    reopenWith("r2", new Vec2(14.5, 2.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit(new Where.Point(new Vec2(5.5, 1.5)), new Where.Point(new Vec2(13.5, 1.5)));
    until(
        view ->
            task(view, task).state() == TaskState.CARRYING
                && !robot(view, "r1").path().points().isEmpty()
                && scriptedRobot("r1").isDriving());
    List<Vec2> straight = robot(stage.fleet.snapshots().latest(), "r1").path().points();
    assertTrue(
        straight.stream().allMatch(p -> Math.abs(p.y() - 1.5) < 1e-6), "through the obstacle");

    Cell obstacle = new Cell(11, 1);
    scriptedRobot("r2").setObstacles(GRID.centre(obstacle));

    until(
        view -> {
          assertNotEquals(obstacle, GRID.cellAt(scriptedRobot("r1").position()));
          return task(view, task).state() == TaskState.DONE;
        });
  }

  @Test
  void aRobotThatAnObstacleStopsSaysSoAndGoesOnWhenItIsGone() throws Exception {
    reopenWith("r2", new Vec2(3.5, 2.5), null);
    scriptedRobot("r2").setObstacles(DOOR);
    until(view -> obstacles(view).equals(cells(GRID.cellAt(DOOR))));

    long task = submit("West", "East");

    until(view -> waitReason(view, task).contains("an obstacle"));
    FleetSnapshot waiting = stage.fleet.snapshots().latest();
    assertTrue(waitReason(waiting, task).contains("(4.50, 1.50)"));
    String robot = task(waiting, task).robots().getFirst();
    assertEquals(waitReason(waiting, task), robot(waiting, robot).work().doing().english(), robot);
    scriptedRobot("r2").setObstacles();
    until(view -> task(view, task).state() == TaskState.DONE);
  }
}
