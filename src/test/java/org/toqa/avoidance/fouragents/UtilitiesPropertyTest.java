package org.toqa.avoidance.fouragents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

class UtilitiesPropertyTest {
  private static final double DANGER = 0.05;

  @Example
  void navigationHasItsFullUtilityWithinAHundredMillimetres() {
    assertEquals(1, Utilities.navigation(0.099, 0.1, 0.3));
    assertEquals(0.65, Utilities.navigation(0.15, 0.1, 0.3), 1e-12); // halfway down
    assertEquals(0.3, Utilities.navigation(5, 0.1, 0.3), 1e-12);
  }

  @Property
  void nothingOutOfTheDangerousZoneMatters(
      @ForAll @DoubleRange(min = DANGER, max = 1) double range) {
    assertEquals(0, Utilities.dynamicAvoidance(Collections.nCopies(RangeRing.SIZE, range), DANGER));
  }

  @Property
  void dynamicUtilityRisesAsSomethingComesNearer(
      @ForAll @DoubleRange(min = 0, max = DANGER) double range,
      @ForAll @DoubleRange(min = 0, max = DANGER) double nearer) {
    double near = Math.min(range, nearer);
    double far = Math.max(range, nearer);
    for (int sensor = 0; sensor < RangeRing.SIZE; sensor++) {
      assertTrue(utility(sensor, near) >= utility(sensor, far));
    }
    assertTrue(utility(2, far) >= utility(6, far), "what is ahead counts more");
  }

  private static double utility(int sensor, double range) {
    List<Double> ranges = new ArrayList<>(Collections.nCopies(RangeRing.SIZE, 1.0));
    ranges.set(sensor, range);
    return Utilities.dynamicAvoidance(ranges, DANGER);
  }

  @Property
  void twoAgentsDoNotAlternateWhileUtilitiesDifferByLessThanTheHysteresis(
      @ForAll @DoubleRange(min = 0.2, max = 0.29) double one,
      @ForAll @DoubleRange(min = 0.2, max = 0.29) double other) {
    DrivingAgent present = DrivingAgent.NAVIGATION;
    for (int i = 0; i < 4; i++) {
      Utilities now = i % 2 == 0 ? new Utilities(one, other, 0) : new Utilities(other, one, 0);
      assertEquals(present, now.choose(present, 0.1));
    }
  }

  @Property
  void theAgentThatDrivesIsWithinTheHysteresisOfTheBest(
      @ForAll @DoubleRange(min = 0, max = 1) double n,
      @ForAll @DoubleRange(min = 0, max = 1) double s,
      @ForAll @DoubleRange(min = 0, max = 1) double d,
      @ForAll DrivingAgent present) {
    Utilities utilities = new Utilities(n, s, d);

    double chosen = utilities.of(utilities.choose(present, 0.1));

    assertTrue(chosen >= Math.max(n, Math.max(s, d)) - 0.1 - 1e-12);
  }

  @Example
  void atTheTargetWhatIsImminentGoesFirst() {
    Utilities utilities = new Utilities(1, 0, 1);

    assertEquals(DrivingAgent.DYNAMIC_AVOIDANCE, utilities.choose(DrivingAgent.NAVIGATION, 0.1));
  }

  @Example
  void whatIsKnownIsNoUnknownObstacleAndABrokenSensorIsOne() {
    RangeRing ring = new RangeRing(0.035, 0.1);
    Perception perception = new Perception(ring, 0.01);
    List<Double> ranges = new ArrayList<>(Collections.nCopies(RangeRing.SIZE, 0.1));
    ranges.set(0, 0.02); // at (0, 0.055), on the rim of the known obstacle
    ranges.set(2, 0.02);
    ranges.set(5, Double.NaN);
    StaticObstacle known = new StaticObstacle(new Vec2(0, 0.155), 0.1);

    Percept percept = perception.percept(ranges, new Pose(0, 0, 0), List.of(known));

    assertEquals(List.of(0.02, 0.1, 0.02, 0.1, 0.1, 0.0, 0.1, 0.1), percept.ranges());
    assertEquals(List.of(0.1, 0.1, 0.02, 0.1, 0.1, 0.0, 0.1, 0.1), percept.unknown());
  }
}
