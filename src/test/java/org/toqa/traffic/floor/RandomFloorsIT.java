package org.toqa.traffic.floor;

import java.util.function.LongConsumer;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

/**
 * What {@link FloorTrafficPropertyTest} does on a few random floors, on a thousand of each kind.
 */
@Tag("full")
class RandomFloorsIT {
  private static final int FLOORS = Integer.getInteger("toqa.floors", 40);

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

  private static Stream<DynamicTest> floors(LongConsumer drive) {
    return LongStream.rangeClosed(1, FLOORS)
        .mapToObj(seed -> DynamicTest.dynamicTest("floor " + seed, () -> drive.accept(seed)));
  }
}
