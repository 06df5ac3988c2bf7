package org.toqa.traffic.lifelong;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;

/** A robot that will only be in some steps where it is planned from. */
class LateRobotTest {
  private static final RoadGraph ROADS = new RoadGraph(OccupancyGrid.parse("........"));
  private static final Cell GOAL = new Cell(7, 0);

  @ParameterizedTest
  @EnumSource
  void goesOnNoEarlierThoughNothingIsPlannedAnew(MotionModel model) {
    LifelongPlanner planner = new RollingHorizonPlanner(model, false, 1);
    GridPose next = plan(planner, 0, 0, Deadline.none()).at(1);
    assertEquals(new Cell(1, 0), next.cell());

    PlannedPath path = plan(planner, 1, 2, new Deadline(() -> 1, 0));

    assertEquals(List.of(next, next, next), path.poses().subList(0, 3));
    assertNotEquals(next, path.at(3));
  }

  @ParameterizedTest
  @EnumSource
  void whoComesBehindALateOneGoesOnAsSoonAsThat(MotionModel model) {
    LifelongPlanner planner = new RollingHorizonPlanner(model, false, 1);
    planner.plan(queue(0), Deadline.none());

    LifelongPlan plan = planner.plan(queue(1), new Deadline(() -> 1, 0));

    assertEquals(new Cell(2, 0), plan.path(0).at(2).cell()); // a step late
    assertEquals(new Cell(0, 0), plan.path(1).at(1).cell());
    assertEquals(new Cell(1, 0), plan.path(1).at(2).cell()); // as soon as that is free
  }

  @ParameterizedTest
  @EnumSource
  void turnsAsSoonAsItIsThere(MotionModel model) {
    RoadGraph corner = new RoadGraph(OccupancyGrid.parse("...", "#.#", "#.#"));
    Cell bend = new Cell(1, 0);
    PlannedRobot late =
        new PlannedRobot("late", new GridPose(bend, Heading.EAST), new Cell(1, 2), 0, false, 1);

    PlannedPath path =
        new RollingHorizonPlanner(model, false, 1)
            .plan(new TrafficSnapshot(corner, List.of(late), new BitSet(), 0), Deadline.none())
            .path(0);

    int turns = model == MotionModel.TURNS ? 1 : 0;
    assertEquals(bend, path.at(1 + turns).cell());
    assertEquals(new Cell(1, 1), path.at(2 + turns).cell());
  }

  /** Two one behind the other, the first of them late. */
  private static TrafficSnapshot queue(int delay) {
    GridPose first = new GridPose(new Cell(1, 0), Heading.EAST);
    GridPose second = new GridPose(new Cell(0, 0), Heading.EAST);
    List<PlannedRobot> robots =
        List.of(
            new PlannedRobot("first", first, GOAL, 0, false, delay),
            new PlannedRobot("second", second, GOAL, 0, false, 0));
    return new TrafficSnapshot(ROADS, robots, new BitSet(), 0);
  }

  /** The only robot's path; no step has passed since the last one. */
  private static PlannedPath plan(
      LifelongPlanner planner, int column, int delay, Deadline deadline) {
    GridPose pose = new GridPose(new Cell(column, 0), Heading.EAST);
    PlannedRobot robot = new PlannedRobot("late", pose, GOAL, 0, false, delay);
    return planner
        .plan(new TrafficSnapshot(ROADS, List.of(robot), new BitSet(), 0), deadline)
        .path(0);
  }
}
