package org.toqa.agent.chassis;

import org.toqa.motion.WheelSpeeds;

/**
 * One value for each wheel of a body with three: radians turned, or a factor of them. A body with
 * two has no third one, whose value does not matter.
 */
record ThreeWheels(double one, double two, double three) {

  static final ThreeWheels ZERO = new ThreeWheels(0, 0, 0);

  /**
   * What the wheels turn.
   *
   * @param seconds so long at these speeds
   */
  static ThreeWheels turned(WheelSpeeds speeds, double seconds) {
    return new ThreeWheels(
        speeds.first() * seconds, speeds.second() * seconds, speeds.third() * seconds);
  }

  /** The speeds at which they turn so far in one second. */
  WheelSpeeds perSecond() {
    return new WheelSpeeds(one, two, three);
  }

  /**
   * @param wheels how many the body has
   */
  double[] values(int wheels) {
    return wheels == 3 ? new double[] {one, two, three} : new double[] {one, two};
  }

  /**
   * @param wheel from 0
   */
  ThreeWheels with(int wheel, double value) {
    return new ThreeWheels(
        wheel == 0 ? value : one, wheel == 1 ? value : two, wheel == 2 ? value : three);
  }

  /** Each value times the other's for the same wheel. */
  ThreeWheels times(ThreeWheels factors) {
    return new ThreeWheels(one * factors.one, two * factors.two, three * factors.three);
  }

  ThreeWheels plus(ThreeWheels other) {
    return new ThreeWheels(one + other.one, two + other.two, three + other.three);
  }
}
