package org.toqa.agent.chassis;

/**
 * One value for each wheel of a body with three: radians turned, or radians a second. A body with
 * two has no third one, whose value stays 0.
 */
record ThreeWheels(double one, double two, double three) {

  static final ThreeWheels ZERO = new ThreeWheels(0, 0, 0);

  static ThreeWheels of(double... values) {
    return new ThreeWheels(values[0], values[1], values.length < 3 ? 0 : values[2]);
  }

  /**
   * @param wheels how many the body has
   */
  double[] values(int wheels) {
    return wheels == 3 ? new double[] {one, two, three} : new double[] {one, two};
  }

  double largest() {
    return Math.max(Math.abs(one), Math.max(Math.abs(two), Math.abs(three)));
  }

  ThreeWheels times(double factor) {
    return new ThreeWheels(one * factor, two * factor, three * factor);
  }

  /** Each value times the other's for the same wheel. */
  ThreeWheels times(ThreeWheels factors) {
    return new ThreeWheels(one * factors.one, two * factors.two, three * factors.three);
  }

  ThreeWheels plus(ThreeWheels other) {
    return new ThreeWheels(one + other.one, two + other.two, three + other.three);
  }

  ThreeWheels minus(ThreeWheels other) {
    return plus(other.times(-1));
  }

  /** The same direction, no value beyond {@code limit}. */
  ThreeWheels limited(double limit) {
    double largest = largest();
    return largest <= limit ? this : times(limit / largest);
  }
}
