package org.toqa.avoidance.fouragents;

import java.util.List;

/**
 * The navigation agent: to the target where nothing is in the way, by a zero-order Takagi-Sugeno
 * controller of 3 x 5 rules. Inputs are the target's distance d and its angle phi from the heading,
 * outputs the two wheel speeds. The seed's tables are lost; these are ours:
 *
 * <ul>
 *   <li>d: at (0), near (the arrival distance), far (twice that): the speed s = 0, 0.5 and 1;
 *   <li>phi: ahead (0): both wheels s; aside (30 degrees): the inner wheel 0.2 s; beside (90
 *       degrees) and beyond: the wheels 0.5 s against each other, so the robot turns on the spot.
 * </ul>
 */
final class Navigation {
  private static final double[] SPEEDS = {0, 0.5, 1};

  /** Left and right wheel as parts of the speed, for the terms of phi from right to left. */
  private static final double[][] WHEELS = {{0.5, -0.5}, {1, 0.2}, {1, 1}, {0.2, 1}, {-0.5, 0.5}};

  private final double wheelSpeed;
  private final RuleTable table;

  /**
   * @param wheelSpeed metres a second, of both wheels where the target is far ahead
   * @param arrival metres: the robot slows down within twice that of the target
   */
  Navigation(double wheelSpeed, double arrival) {
    this.wheelSpeed = wheelSpeed;
    double aside = Math.toRadians(30);
    double beside = Math.toRadians(90);
    this.table =
        new RuleTable(
            List.of(
                new Partition(0, arrival, 2 * arrival),
                new Partition(-beside, -aside, 0, aside, beside)),
            consequents());
  }

  private static double[][] consequents() {
    double[][] rules = new double[SPEEDS.length * WHEELS.length][];
    for (int i = 0; i < rules.length; i++) {
      double speed = SPEEDS[i / WHEELS.length];
      double[] wheels = WHEELS[i % WHEELS.length];
      rules[i] = new double[] {speed * wheels[0], speed * wheels[1]};
    }
    return rules;
  }

  int ruleCount() {
    return table.ruleCount();
  }

  /**
   * @param distance d, metres
   * @param angle phi, radians from the heading, counter-clockwise, in (-pi, pi]
   */
  WheelVelocities velocities(double distance, double angle) {
    double[] parts = table.outputs(distance, angle);
    return new WheelVelocities(parts[0] * wheelSpeed, parts[1] * wheelSpeed);
  }
}
