package org.toqa.traffic.floor;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.grid.Moves;
import org.toqa.testbed.Cases;

/**
 * What {@link FloorTrafficPropertyTest} asks, on floors whose robots drive smooth curves: they
 * arrive, and {@link DrivenFloor} sees to it that none touch each other or a wall, and that all
 * keep what is drawn.
 */
@Tag("full")
class SmoothPathsPropertyTest {
  private final Cases floors = new Cases("generated floors");

  @Property(tries = 10, seed = "20261127")
  void onRandomFloorsEveryRobotArrives(@ForAll @LongRange(min = 0) long seed) {
    floors.count(FloorTrafficPropertyTest.driveToThreeGoals(seed, Moves.SMOOTH));
  }

  @Property(tries = 3, seed = "20261127")
  void fromWhereverItStandsARobotArrives(@ForAll @LongRange(min = 0) long seed) {
    floors.count(FloorTrafficPropertyTest.driveFromAnywhere(seed, Moves.SMOOTH));
  }

  @Property(tries = 2, seed = "20261127")
  void onFineMapsEveryRobotArrives(@ForAll @LongRange(min = 0) long seed) {
    floors.count(FloorTrafficPropertyTest.driveOnAFineMap(seed, Moves.SMOOTH));
  }

  @Property(tries = 5, seed = "20261127")
  void newGoalsStopsAndLossesDisturbNothing(@ForAll @LongRange(min = 0) long seed) {
    floors.count(FloorTrafficPropertyTest.driveThroughTroubles(seed, Moves.SMOOTH));
  }

  @AfterProperty
  void floorsHadRoomForRobots() {
    floors.assertPossible(0.9);
  }
}
