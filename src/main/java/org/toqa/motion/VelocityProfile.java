package org.toqa.motion;

/**
 * How fast a line is driven, at equal steps of time.
 *
 * @param step seconds from one value to the next
 * @param speeds metres a second, linear between; the first and the last are 0
 * @param distances metres driven by then
 */
public record VelocityProfile(double step, double[] speeds, double[] distances) {

  /** Seconds in all. */
  public double duration() {
    return step * (speeds.length - 1);
  }

  /** Metres a second at a moment; 0 before the start and after the end. */
  public double speedAt(double seconds) {
    return at(speeds, seconds);
  }

  /** Metres driven at a moment. */
  public double distanceAt(double seconds) {
    int before = (int) Math.clamp(Math.floor(seconds / step), 0, Math.max(0, speeds.length - 2.0));
    if (seconds >= duration()) {
      return distances[distances.length - 1];
    }
    double passed = Math.max(0, seconds - before * step);
    // s + v t + a t^2 / 2
    double acceleration = (speeds[before + 1] - speeds[before]) / step;
    return distances[before] + speeds[before] * passed + acceleration * passed * passed / 2;
  }

  private double at(double[] values, double seconds) {
    if (seconds <= 0 || seconds >= duration()) {
      return 0;
    }
    int before = (int) Math.min(values.length - 2.0, Math.floor(seconds / step));
    double share = seconds / step - before;
    return values[before] + share * (values[before + 1] - values[before]);
  }
}
