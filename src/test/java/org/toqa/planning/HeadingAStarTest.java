package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.PlanResult.NotFound;
import org.toqa.planning.PlanResult.Reason;

class HeadingAStarTest {
  private final PathPlanner planner = new HeadingAStar();

  private Path found(OccupancyGrid grid, Cell start, Cell goal) {
    return assertInstanceOf(Found.class, planner.plan(grid, start, goal)).path();
  }

  @Test
  void bendInAOneCellAisleIsTurnedOnTheSpot() {
    OccupancyGrid aisle =
        OccupancyGrid.parse(
            "...#", //
            "##.#", "##.#");
    Path path = found(aisle, new Cell(0, 0), new Cell(2, 2));
    assertEquals(1, path.turnsOnSpot());
    assertEquals(5, path.cost()); // 4 cells, and 90 degrees that cost as much as one
    assertEquals(
        List.of(
            new Waypoint(new Vec2(2.5, 2.5), true), //
            new Waypoint(new Vec2(2.5, 0.5), false)),
        path.waypoints(aisle));
  }

  @Test
  void wideCornerIsTakenInTwoBendsOf45Degrees() {
    OccupancyGrid hall =
        OccupancyGrid.parse(
            "....", //
            "....", "##..", "##..");
    Path path = found(hall, new Cell(0, 0), new Cell(3, 3));
    assertEquals(0, path.turnsOnSpot());
    assertEquals(2 + 2 * Math.sqrt(2), path.cost(), 1e-12); // straight, two diagonal, straight
    assertEquals(4, path.cells().size() - 1);
  }

  @Test
  void diagonalMoveCutsNoCorner() {
    OccupancyGrid corner =
        OccupancyGrid.parse(
            ".#", //
            "..");
    Path path = found(corner, new Cell(0, 0), new Cell(1, 1));
    assertEquals(List.of(new Cell(0, 0), new Cell(0, 1), new Cell(1, 1)), path.cells());
  }

  @Test
  void straightWayHasItsGoalAsItsOnlyWaypoint() {
    OccupancyGrid lane = OccupancyGrid.parse(".....");
    Path path = found(lane, new Cell(4, 0), new Cell(0, 0));
    assertEquals(List.of(new Waypoint(new Vec2(0.5, 0.5), false)), path.waypoints(lane));
  }

  @Test
  void robotAtItsGoalStays() {
    OccupancyGrid cell = OccupancyGrid.parse(".");
    Path path = found(cell, new Cell(0, 0), new Cell(0, 0));
    assertEquals(0, path.cost());
    assertEquals(List.of(), path.waypoints(cell));
  }

  @Test
  void whyThereIsNoWayIsNamed() {
    OccupancyGrid grid = OccupancyGrid.parse("..#.");
    assertEquals(
        new NotFound(Reason.START_BLOCKED, new Cell(2, 0)),
        planner.plan(grid, new Cell(2, 0), new Cell(0, 0)));
    assertEquals(
        new NotFound(Reason.GOAL_BLOCKED, new Cell(9, 9)),
        planner.plan(grid, new Cell(0, 0), new Cell(9, 9)));
    assertEquals(
        new NotFound(Reason.NO_PATH, new Cell(3, 0)),
        planner.plan(grid, new Cell(0, 0), new Cell(3, 0)));
  }
}
