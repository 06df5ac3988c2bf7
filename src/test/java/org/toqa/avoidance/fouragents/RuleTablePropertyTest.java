package org.toqa.avoidance.fouragents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;

class RuleTablePropertyTest {
  private static final double ROUNDING = 1e-12;
  private static final double SPEED = 0.1;
  private static final double DANGER = 0.05;

  @Property
  void aTableIsTheWeightedMeanOfAllItsRules(
      @ForAll @DoubleRange(min = -1, max = 3) double a,
      @ForAll @DoubleRange(min = -2, max = 2) double b) {
    double[] first = {0, 1, 2};
    double[] second = {-1, 0.5};
    double[][] consequents = {{3, 1}, {-2, 0}, {5, 5}, {0, -4}, {1, 2}, {7, -1}};
    RuleTable table =
        new RuleTable(List.of(new Partition(first), new Partition(second)), consequents);
    double weights = 0;
    double[] sum = new double[2];
    for (int i = 0; i < first.length; i++) {
      for (int j = 0; j < second.length; j++) {
        double w = triangle(first, i, a) * triangle(second, j, b);
        weights += w;
        sum[0] += w * consequents[i * second.length + j][0];
        sum[1] += w * consequents[i * second.length + j][1];
      }
    }

    double[] outputs = table.outputs(a, b);

    assertEquals(sum[0] / weights, outputs[0], ROUNDING);
    assertEquals(sum[1] / weights, outputs[1], ROUNDING);
  }

  /** The height of a triangle over a value that is brought into the range of the peaks. */
  private static double triangle(double[] peaks, int term, double value) {
    double x = Math.max(peaks[0], Math.min(peaks[peaks.length - 1], value));
    double left = term == 0 ? Double.NEGATIVE_INFINITY : peaks[term - 1];
    double right = term == peaks.length - 1 ? Double.POSITIVE_INFINITY : peaks[term + 1];
    if (x <= left || x >= right) {
      return 0;
    }
    return x < peaks[term]
        ? (x - left) / (peaks[term] - left)
        : x == peaks[term] ? 1 : (right - x) / (right - peaks[term]);
  }

  @Example
  void theHierarchyHasFewerThanAHundredRules() {
    FourAgents agents = new FourAgents(FourAgentsSettings.of(DifferentialBody.KHEPERA_II));

    assertEquals(8 * 3 + 16 + 4 + 16 + 27, agents.dynamicRules());
    assertTrue(agents.dynamicRules() < 100);
    assertEquals(3 * 5, agents.navigationRules());
  }

  @Provide
  Arbitrary<List<Double>> ranges() {
    return Arbitraries.doubles().between(0, 2 * DANGER).list().ofSize(RangeRing.SIZE);
  }

  @Property
  void dynamicAvoidanceKeepsTheLimitsOfTheWheels(@ForAll("ranges") List<Double> ranges) {
    WheelVelocities wheels = new DynamicAvoidance(SPEED, DANGER).velocities(ranges);

    assertTrue(Math.abs(wheels.left()) <= SPEED + ROUNDING);
    assertTrue(Math.abs(wheels.right()) <= SPEED + ROUNDING);
  }

  @Property
  void navigationMirrorsLeftAndRightAndKeepsTheLimits(
      @ForAll @DoubleRange(min = 0, max = 3) double distance,
      @ForAll @DoubleRange(min = -3.14, max = 3.14) double angle) {
    Navigation navigation = new Navigation(SPEED, 0.1);

    WheelVelocities here = navigation.velocities(distance, angle);
    WheelVelocities mirrored = navigation.velocities(distance, -angle);

    assertEquals(here.left(), mirrored.right(), ROUNDING);
    assertEquals(here.right(), mirrored.left(), ROUNDING);
    assertTrue(Math.max(Math.abs(here.left()), Math.abs(here.right())) <= SPEED + ROUNDING);
    assertTrue(angle <= 0 || here.right() >= here.left());
  }

  /** Whatever one side sees more than the other, the robot turns away from. */
  @Property
  void dynamicAvoidanceTurnsAwayFromTheSideThatIsNearer(
      @ForAll @DoubleRange(min = 0, max = DANGER) double near) {
    List<Double> ranges = new ArrayList<>(Collections.nCopies(RangeRing.SIZE, 2 * DANGER));
    DynamicAvoidance dynamic = new DynamicAvoidance(SPEED, DANGER);
    ranges.set(1, near);
    WheelVelocities leftNear = dynamic.velocities(ranges);
    ranges.set(1, 2 * DANGER);
    ranges.set(4, near);
    WheelVelocities rightNear = dynamic.velocities(ranges);

    assertTrue(leftNear.left() > leftNear.right());
    assertEquals(leftNear.left(), rightNear.right(), ROUNDING);
    assertEquals(leftNear.right(), rightNear.left(), ROUNDING);
  }

  @Example
  void whatSeesNothingDrivesStraightOnAtFullSpeed() {
    List<Double> nothing = Collections.nCopies(RangeRing.SIZE, 2 * DANGER);

    assertEquals(
        new WheelVelocities(SPEED, SPEED), new DynamicAvoidance(SPEED, DANGER).velocities(nothing));
  }
}
