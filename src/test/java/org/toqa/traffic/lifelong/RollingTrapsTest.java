package org.toqa.traffic.lifelong;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;

/** The classic traps, driven step by step in both models. */
class RollingTrapsTest {
  private static final List<Cell> RING =
      List.of(at(0, 0), at(1, 0), at(2, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 2), at(0, 1));

  private static final OccupancyGrid AROUND_A_PILLAR = OccupancyGrid.parse("...", ".#.", "...");

  @ParameterizedTest
  @EnumSource
  void twoRobotsSwapInAnAisleWithOneBay(MotionModel model) {
    OccupancyGrid grid = OccupancyGrid.parse(".......", "###.###");

    drive(grid, model, List.of(at(0, 0), at(6, 0)), List.of(at(6, 0), at(0, 0))).untilArrived(2000);
  }

  @ParameterizedTest
  @EnumSource
  void aFullRingTurnsWhereRobotsMayGoAllAtOnce(MotionModel model) {
    List<Cell> byOne = IntStream.range(0, 8).mapToObj(k -> RING.get((k + 1) % 8)).toList();

    drive(AROUND_A_PILLAR, model, RING, byOne).untilArrived(200);
  }

  @ParameterizedTest
  @EnumSource
  void aFullRingStaysWhereACellMustBeLeftBeforeItIsEntered(MotionModel model) {
    List<Cell> byOne = IntStream.range(0, 8).mapToObj(k -> RING.get((k + 1) % 8)).toList();
    Drive drive =
        new Drive(AROUND_A_PILLAR, model, new RollingHorizonPlanner(model, false, 1), RING, byOne);

    for (int step = 0; step < 50; step++) {
      drive.step();
    }

    assertEquals(RING, IntStream.range(0, 8).mapToObj(r -> drive.stance(r).cell()).toList());
    assertEquals(PlanStatus.DRIVING, drive.prospect(0));
  }

  @ParameterizedTest
  @EnumSource
  void aRingWithOneGapTurnsThoughACellMustBeLeftBeforeItIsEntered(MotionModel model) {
    List<Cell> byOne = IntStream.range(0, 7).mapToObj(k -> RING.get(k + 1)).toList();

    new Drive(
            AROUND_A_PILLAR,
            model,
            new RollingHorizonPlanner(model, false, 1),
            RING.subList(0, 7),
            byOne)
        .untilArrived(500);
  }

  @ParameterizedTest
  @EnumSource
  void fourArriveAtACrossingAtOnceAndGoStraightOn(MotionModel model) {
    OccupancyGrid grid = OccupancyGrid.parse("##.##", "##.##", ".....", "##.##", "##.##");

    drive(
            grid,
            model,
            List.of(at(1, 2), at(3, 2), at(2, 1), at(2, 3)),
            List.of(at(4, 2), at(0, 2), at(2, 4), at(2, 0)))
        .untilArrived(2000);
  }

  @ParameterizedTest
  @EnumSource
  void aRobotParkedInADoorwayMakesWayAndComesBack(MotionModel model) {
    OccupancyGrid grid = OccupancyGrid.parse("..#..", ".....", "..#..");

    drive(grid, model, List.of(at(0, 1), at(2, 1)), List.of(at(4, 1), at(2, 1))).untilArrived(200);
  }

  @ParameterizedTest
  @EnumSource
  void othersGoRoundARobotThatIsFixedOnItsWay(MotionModel model) {
    OccupancyGrid grid = OccupancyGrid.parse(".....", ".###.", ".....");
    Drive drive = drive(grid, model, List.of(at(1, 0), at(4, 0)), List.of(at(4, 2), at(0, 0)));
    drive.step();
    drive.step();
    GridPose fixed = drive.stance(0);
    drive.fix(0, true);

    for (int step = 0; step < 200 && !drive.isArrived(1); step++) {
      drive.step();
      assertEquals(fixed, drive.stance(0));
    }

    assertTrue(drive.isArrived(1));
    assertEquals(PlanStatus.FIXED, drive.prospect(0));
    drive.fix(0, false);
    drive.untilArrived(200);
  }

  @ParameterizedTest
  @EnumSource
  void aBlockedGoalAndARobotWithoutAWayAreNamedAndTheOthersDrive(MotionModel model) {
    OccupancyGrid grid = OccupancyGrid.parse("....#.");
    Drive drive =
        drive(
            grid,
            model,
            List.of(at(0, 0), at(1, 0), at(2, 0)),
            List.of(at(4, 0), at(5, 0), at(3, 0)));

    drive.step();

    assertEquals(PlanStatus.GOAL_BLOCKED, drive.prospect(0));
    assertEquals(PlanStatus.NO_PATH, drive.prospect(1));
    assertEquals(PlanStatus.ARRIVED, drive.prospect(2));
    assertEquals(at(0, 0), drive.stance(0).cell());
  }

  @ParameterizedTest
  @EnumSource
  void aRobotThatWantsNothingMakesWayInADeadEnd(MotionModel model) {
    OccupancyGrid grid = OccupancyGrid.parse("...", "#.#", "#.#");
    Drive drive = drive(grid, model, List.of(at(1, 1), at(0, 0)), List.of(at(1, 1), at(1, 2)));

    for (int step = 0; step < 2000 && !drive.isArrived(1); step++) {
      drive.step();
    }

    assertTrue(drive.isArrived(1));
  }

  @ParameterizedTest
  @EnumSource
  void whoStandsInAWallOrOnAnotherIsNamedAndStays(MotionModel model) {
    OccupancyGrid grid = OccupancyGrid.parse("...#");
    Drive drive = drive(grid, model, List.of(at(0, 0), at(2, 0)), List.of(at(2, 0), at(0, 0)));
    drive.driveOn(OccupancyGrid.parse("..##"));

    assertEquals(PlanStatus.START_BLOCKED, drive.prospect(1));
    assertEquals(PlanStatus.GOAL_BLOCKED, drive.prospect(0));
    assertFalse(drive.areAllArrived());
  }

  private static Drive drive(
      OccupancyGrid grid, MotionModel model, List<Cell> starts, List<Cell> goals) {
    return new Drive(grid, model, new RollingHorizonPlanner(model, true, 1), starts, goals);
  }

  private static Cell at(int column, int row) {
    return new Cell(column, row);
  }
}
