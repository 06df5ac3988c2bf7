package org.toqa.agent.chassis;

/** One value for each wheel of a three-wheeled body: radians turned, or radians a second. */
record ThreeWheels(double one, double two, double three) {

  static final ThreeWheels ZERO = new ThreeWheels(0, 0, 0);

  static ThreeWheels of(double... values) {
    return new ThreeWheels(values[0], values[1], values[2]);
  }

  double[] values() {
    return new double[] {one, two, three};
  }

  double largest() {
    return Math.max(Math.abs(one), Math.max(Math.abs(two), Math.abs(three)));
  }

  ThreeWheels times(double factor) {
    return new ThreeWheels(one * factor, two * factor, three * factor);
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
