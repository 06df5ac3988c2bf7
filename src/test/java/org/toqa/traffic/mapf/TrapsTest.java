package org.toqa.traffic.mapf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.mapf.MapfResult.Culprit;
import org.toqa.traffic.mapf.MapfResult.Reason;
import org.toqa.traffic.mapf.MapfResult.Solved;
import org.toqa.traffic.mapf.MapfResult.Unsolved;

/** The classic traps, planned in one go. */
class TrapsTest {

  @Test
  void twoRobotsSwapInAnAisleWithOneBay() {
    OccupancyGrid grid = OccupancyGrid.parse(".......", "##.####");

    assertSolved(grid, List.of(at(0, 0), at(6, 0)), List.of(at(6, 0), at(0, 0)));
  }

  @Test
  void inAnAisleWithoutBayNobodyPretendsThatTwoCanSwap() {
    OccupancyGrid grid = OccupancyGrid.parse("....");

    assertEquals(
        new Unsolved(Reason.NO_PLAN, null),
        solve(grid, List.of(at(0, 0), at(3, 0)), List.of(at(3, 0), at(0, 0))));
  }

  @Test
  void aFullRingTurnsByOne() {
    OccupancyGrid grid = OccupancyGrid.parse("...", ".#.", "...");
    List<Cell> ring =
        List.of(at(0, 0), at(1, 0), at(2, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 2), at(0, 1));
    List<Cell> byOne =
        List.of(at(1, 0), at(2, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 2), at(0, 1), at(0, 0));

    Solved solved = assertSolved(grid, ring, byOne);

    // All go at once: 8 robots, a step each.
    assertEquals(8, solved.plan().sumOfCosts());
  }

  @Test
  void fourArriveAtACrossingAtOnceAndGoStraightOn() {
    OccupancyGrid grid = OccupancyGrid.parse("##.##", "##.##", ".....", "##.##", "##.##");

    assertSolved(
        grid,
        List.of(at(1, 2), at(3, 2), at(2, 1), at(2, 3)),
        List.of(at(4, 2), at(0, 2), at(2, 4), at(2, 0)));
  }

  @Test
  void aRobotParkedInADoorwayMakesWayAndComesBack() {
    OccupancyGrid grid = OccupancyGrid.parse("..#..", ".....", "..#..");

    assertSolved(grid, List.of(at(0, 1), at(2, 1)), List.of(at(4, 1), at(2, 1)));
  }

  @Test
  void aBlockedStartOrGoalIsNamed() {
    OccupancyGrid grid = OccupancyGrid.parse("..#");

    assertEquals(
        new Unsolved(Reason.GOAL_BLOCKED, new Culprit(1, at(2, 0))),
        solve(grid, List.of(at(0, 0), at(1, 0)), List.of(at(1, 0), at(2, 0))));
    assertEquals(
        new Unsolved(Reason.START_BLOCKED, new Culprit(0, at(2, 0))),
        solve(grid, List.of(at(2, 0)), List.of(at(0, 0))));
  }

  @Test
  void twoRobotsWithOneStartOrOneGoalAreNamed() {
    OccupancyGrid grid = OccupancyGrid.parse("...");

    assertEquals(
        new Unsolved(Reason.START_SHARED, new Culprit(1, at(0, 0))),
        solve(grid, List.of(at(0, 0), at(0, 0)), List.of(at(1, 0), at(2, 0))));
    assertEquals(
        new Unsolved(Reason.GOAL_SHARED, new Culprit(1, at(2, 0))),
        solve(grid, List.of(at(0, 0), at(1, 0)), List.of(at(2, 0), at(2, 0))));
  }

  @Test
  void aRobotWithoutAWayIsNamed() {
    OccupancyGrid grid = OccupancyGrid.parse(".#.");

    assertEquals(
        new Unsolved(Reason.NO_WAY, new Culprit(0, at(2, 0))),
        solve(grid, List.of(at(0, 0)), List.of(at(2, 0))));
  }

  @Test
  void whereTheTimeIsUpBeforeItBeganNothingIsPretended() {
    OccupancyGrid grid = OccupancyGrid.parse("...");
    MapfInstance instance =
        new MapfInstance(new RoadGraph(grid), List.of(at(0, 0)), List.of(at(2, 0)));

    assertEquals(
        new Unsolved(Reason.OUT_OF_TIME, null),
        new OneShotPlanner(1).solve(instance, new Deadline(() -> 0, 0), plan -> {}));
  }

  private static Solved assertSolved(OccupancyGrid grid, List<Cell> starts, List<Cell> goals) {
    Solved solved = assertInstanceOf(Solved.class, solve(grid, starts, goals));
    PlanAssertions.assertSound(new MapfInstance(new RoadGraph(grid), starts, goals), solved);
    return solved;
  }

  private static MapfResult solve(OccupancyGrid grid, List<Cell> starts, List<Cell> goals) {
    AtomicLong asked = new AtomicLong();
    return new OneShotPlanner(1)
        .solve(
            new MapfInstance(new RoadGraph(grid), starts, goals),
            new Deadline(asked::getAndIncrement, 20_000),
            plan -> {});
  }

  private static Cell at(int column, int row) {
    return new Cell(column, row);
  }
}
