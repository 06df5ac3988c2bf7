package org.toqa.traffic.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.toqa.planning.Heading.EAST;
import static org.toqa.planning.Heading.NORTH;
import static org.toqa.planning.Heading.SOUTH;
import static org.toqa.planning.Heading.WEST;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.check.TrafficChecker.Rule;
import org.toqa.traffic.check.TrafficChecker.Violation;

class TrafficCheckerTest {
  private static final OccupancyGrid GRID = OccupancyGrid.parse("...", "..#");

  @Test
  void robotsMayFollowEachOtherAndGoRoundInARing() {
    List<GridPose> before = List.of(at(0, 0), at(1, 0), at(1, 1), at(0, 1));
    List<GridPose> after = List.of(at(1, 0), at(1, 1), at(0, 1), at(0, 0));

    assertEquals(List.of(), classic().check(before, after));
  }

  @Test
  void noRobotStandsInAWallOrOffTheMap() {
    assertEquals(
        List.of(
            new Violation(Rule.ON_A_FREE_CELL, 0, new Cell(2, 1)),
            new Violation(Rule.ON_A_FREE_CELL, 1, new Cell(-1, 0))),
        classic().checkPlaces(List.of(at(2, 1), at(-1, 0))));
  }

  @Test
  void noTwoRobotsShareACell() {
    assertBroken(
        Rule.ALONE_ON_ITS_CELL,
        classic().check(List.of(at(0, 0), at(2, 0)), List.of(at(1, 0), at(1, 0))));
  }

  @Test
  void noTwoRobotsChangePlaces() {
    assertBroken(
        Rule.NO_CHANGING_PLACES,
        classic().check(List.of(at(0, 0), at(1, 0)), List.of(at(1, 0), at(0, 0))));
  }

  @Test
  void aStepLeadsToANeighbourAtMost() {
    assertBroken(Rule.A_STEP_OF_THE_MODEL, classic().check(List.of(at(0, 0)), List.of(at(2, 0))));
    assertBroken(Rule.A_STEP_OF_THE_MODEL, classic().check(List.of(at(0, 0)), List.of(at(1, 1))));
  }

  @Test
  void whoTurnsGoesForwardOnlyAndTurnsAQuarterOnly() {
    assertEquals(List.of(), turn(at(0, 0, EAST), at(1, 0, EAST)));
    assertEquals(List.of(), turn(at(0, 0, EAST), at(0, 0, NORTH)));
    assertEquals(List.of(), turn(at(0, 0, EAST), at(0, 0, SOUTH)));
    assertEquals(List.of(), turn(at(0, 0, EAST), at(0, 0, EAST)));
    assertBroken(Rule.A_STEP_OF_THE_MODEL, turn(at(0, 0, EAST), at(0, 0, WEST)));
    assertBroken(Rule.A_STEP_OF_THE_MODEL, turn(at(0, 0, NORTH), at(1, 0, NORTH)));
    assertBroken(Rule.A_STEP_OF_THE_MODEL, turn(at(1, 0, EAST), at(0, 0, EAST)));
    assertBroken(Rule.A_STEP_OF_THE_MODEL, turn(at(0, 0, EAST), at(1, 0, NORTH)));
  }

  private static List<Violation> turn(GridPose before, GridPose after) {
    return new TrafficChecker(GRID, MotionModel.TURNS).check(List.of(before), List.of(after));
  }

  private static TrafficChecker classic() {
    return new TrafficChecker(GRID, MotionModel.CLASSIC);
  }

  private static void assertBroken(Rule rule, List<Violation> violations) {
    assertEquals(List.of(rule), violations.stream().map(Violation::rule).toList());
  }

  private static GridPose at(int column, int row) {
    return at(column, row, EAST);
  }

  private static GridPose at(int column, int row, Heading heading) {
    return new GridPose(new Cell(column, row), heading);
  }
}
