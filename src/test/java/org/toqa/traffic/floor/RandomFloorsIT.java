package org.toqa.traffic.floor;

import java.util.function.LongPredicate;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.toqa.grid.Moves;
import org.toqa.testbed.Cases;
import org.toqa.testbed.FuzzRun;

/**
 * What {@link FloorTrafficPropertyTest} does on a few random floors, on more of each kind: {@code
 * -Dtoqa.floors=1000}, the first of which is that of {@code -Dtoqa.seed}.
 */
@Tag("full")
class RandomFloorsIT {
  private static final int FLOORS = Integer.getInteger("toqa.floors", 20);
  private static final int FLOORS_A_CROWD = 50;

  @TestFactory
  Stream<DynamicTest> everyRobotReachesThreeGoals() {
    return floors(FloorTrafficPropertyTest::driveToThreeGoals);
  }

  @TestFactory
  Stream<DynamicTest> newGoalsStopsAndLossesDisturbNothing() {
    return floors(FloorTrafficPropertyTest::driveThroughTroubles);
  }

  @TestFactory
  Stream<DynamicTest> everyRobotReachesThreeGoalsOnAFineMap() {
    return floors(FloorTrafficPropertyTest::driveOnAFineMap);
  }

  @TestFactory
  Stream<DynamicTest> fromWhereverItStandsARobotArrives() {
    return floors(FloorTrafficPropertyTest::driveFromAnywhere);
  }

  @TestFactory
  Stream<DynamicTest> everyRobotReachesThreeGoalsByCurves() {
    return floors(seed -> FloorTrafficPropertyTest.driveToThreeGoals(seed, Moves.SMOOTH));
  }

  @TestFactory
  Stream<DynamicTest> newGoalsStopsAndLossesDisturbNothingByCurves() {
    return floors(seed -> FloorTrafficPropertyTest.driveThroughTroubles(seed, Moves.SMOOTH));
  }

  @TestFactory
  Stream<DynamicTest> everyRobotReachesThreeGoalsByCurvesOnAFineMap() {
    return floors(seed -> FloorTrafficPropertyTest.driveOnAFineMap(seed, Moves.SMOOTH));
  }

  @TestFactory
  Stream<DynamicTest> fromWhereverItStandsARobotArrivesByCurves() {
    return floors(seed -> FloorTrafficPropertyTest.driveFromAnywhere(seed, Moves.SMOOTH));
  }

  /** Fewer of these: of 50 robots, 100, 150, 200 and 50 again. */
  @TestFactory
  Stream<DynamicTest> inACrowdNothingTouchesAndEachArrivesOrSaysWhyNot() {
    return floors(
        Math.max(1, FLOORS / FLOORS_A_CROWD),
        seed -> Crowd.drive(seed, 50 * (1 + (int) ((seed - FuzzRun.SEED) % 4))));
  }

  private static Stream<DynamicTest> floors(LongPredicate drive) {
    return floors(FLOORS, drive);
  }

  /** The last one says whether there were enough. */
  private static Stream<DynamicTest> floors(int count, LongPredicate drive) {
    Cases floors = new Cases("generated floors");
    Stream<DynamicTest> driven =
        LongStream.range(FuzzRun.SEED, FuzzRun.SEED + count)
            .mapToObj(
                seed ->
                    DynamicTest.dynamicTest("floor " + seed, () -> floors.count(drive.test(seed))));
    return Stream.concat(
        driven,
        Stream.of(DynamicTest.dynamicTest("floors with room", () -> floors.assertPossible(0.9))));
  }
}
