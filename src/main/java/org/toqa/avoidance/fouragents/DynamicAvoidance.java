package org.toqa.avoidance.fouragents;

import java.util.ArrayList;
import java.util.List;

/**
 * The dynamic avoidance agent: a hierarchy of fuzzy controllers, all zero-order Takagi-Sugeno
 * ({@link RuleTable}). One table over eight sensors of three terms has 3^8 = 6561 rules; this one
 * has 87:
 *
 * <ol>
 *   <li>one controller a sensor: range (near, medium, far) to an index of danger, 8 x 3 rules;
 *   <li>left, front and right: the indices of the group's sensors (low, high) to one of the group,
 *       16 + 4 + 16 rules: as dangerous as the sensor that weighs most;
 *   <li>the three indices (low, medium, high) to the speeds of both wheels, 27 rules.
 * </ol>
 *
 * <p>The seed's tables are in a paper that it cites and are not published with it; these are ours.
 * Left and right mirror each other, but where both sides are alike the robot turns left.
 */
final class DynamicAvoidance {

  /** Sensors of {@link RangeRing}: beside, aside, ahead, behind. */
  private static final int[] LEFT = {0, 1, 2, 7};

  private static final int[] FRONT = {2, 3};
  private static final int[] RIGHT = {5, 4, 3, 6};

  private static final double[] SIDE_WEIGHTS = {0.7, 1, 0.4, 0.3};
  private static final double[] FRONT_WEIGHTS = {0.8, 0.8};

  /** Left and right wheel, by front, left and right, the last one fastest. */
  private static final double[][] WHEELS = {
    // front low
    {1, 1}, {0.6, 1}, {0.1, 1},
    {1, 0.6}, {0.7, 0.7}, {0.2, 0.7},
    {1, 0.1}, {0.7, 0.2}, {0.4, 0.4},
    // front medium
    {-0.4, 0.5}, {-0.5, 0.5}, {-0.6, 0.4},
    {0.5, -0.5}, {-0.5, 0.1}, {-0.6, 0},
    {0.4, -0.6}, {0, -0.6}, {-0.4, -0.4},
    // front high: backward faster than what comes at half the robot's speed
    {-1, -0.2}, {-1, -0.3}, {-1, -0.4},
    {-0.3, -1}, {-1, -0.6}, {-1, -0.5},
    {-0.4, -1}, {-0.5, -1}, {-1, -1},
  };

  private final double wheelSpeed;
  private final RuleTable sensor;
  private final RuleTable side = group(SIDE_WEIGHTS);
  private final RuleTable front = group(FRONT_WEIGHTS);
  private final RuleTable wheels;

  /**
   * @param wheelSpeed metres a second, the most of each wheel
   * @param danger metres from the rim: the middle term of a range
   */
  DynamicAvoidance(double wheelSpeed, double danger) {
    this.wheelSpeed = wheelSpeed;
    this.sensor =
        new RuleTable(
            List.of(new Partition(0.4 * danger, danger, 2 * danger)),
            new double[][] {{1}, {0.5}, {0}});
    Partition index = new Partition(0, 0.5, 1);
    this.wheels = new RuleTable(List.of(index, index, index), WHEELS);
  }

  /** A group's table: each rule has the largest weight of its sensors that are high. */
  private static RuleTable group(double[] weights) {
    List<Partition> inputs = new ArrayList<>();
    for (int i = 0; i < weights.length; i++) {
      inputs.add(new Partition(0, 1));
    }
    double[][] rules = new double[1 << weights.length][1];
    for (int rule = 0; rule < rules.length; rule++) {
      for (int i = 0; i < weights.length; i++) {
        boolean isHigh = (rule >> (weights.length - 1 - i) & 1) == 1;
        rules[rule][0] = Math.max(rules[rule][0], isHigh ? weights[i] : 0);
      }
    }
    return new RuleTable(inputs, rules);
  }

  int ruleCount() {
    return RangeRing.SIZE * sensor.ruleCount()
        + 2 * side.ruleCount()
        + front.ruleCount()
        + wheels.ruleCount();
  }

  /**
   * @param ranges metres from the rim, one a sensor, to anything
   */
  WheelVelocities velocities(List<Double> ranges) {
    double[] parts =
        wheels.outputs(
            index(front, FRONT, ranges), index(side, LEFT, ranges), index(side, RIGHT, ranges));
    return new WheelVelocities(parts[0] * wheelSpeed, parts[1] * wheelSpeed);
  }

  private double index(RuleTable table, int[] sensors, List<Double> ranges) {
    double[] indices = new double[sensors.length];
    for (int i = 0; i < sensors.length; i++) {
      indices[i] = sensor.outputs(ranges.get(sensors[i]))[0];
    }
    return table.outputs(indices)[0];
  }
}
