package org.toqa.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/**
 * Plans how fast a line is driven, from rest to rest, under limits of speed (by place),
 * acceleration and jerk.
 *
 * <p>Without the limit of jerk the fastest profile is found by one pass forward and one back
 * (Bobrow, Dubowsky and Gibson, "Time-optimal control of robotic manipulators along specified
 * paths", 1985). It is then averaged over a window of T = 2 a / j seconds. An average of speeds is
 * as bounded as they are; its acceleration is an average of accelerations; and its jerk is the
 * difference of two accelerations divided by T, at most 2 a / T = j. As the average of one place is
 * driven within T of it, the limit of each place is first lowered to the least one within the
 * distance of T at full speed.
 *
 * <p>Guaranteed: speed at each place, acceleration and jerk are within their limits, up to the
 * steps of the numbers. Not guaranteed: that no faster profile is within the limit of jerk; the
 * time is at most T, and what is lost beside bends, longer than that of the profile without it.
 */
public final class VelocityPlanner {
  /** Pieces of a line at most; more are coarser. */
  private static final int MOST_PIECES = 200_000;

  /** Metres of a piece, where they are not too many. */
  private static final double PIECE = 0.002;

  /** Steps of time in a window. */
  private static final int STEPS_OF_WINDOW = 64;

  private final double fastest;
  private final double acceleration;
  private final double jerk;

  /**
   * @param fastest metres a second, above 0
   * @param acceleration metres a second squared, above 0
   * @param jerk metres a second cubed, above 0
   */
  public VelocityPlanner(double fastest, double acceleration, double jerk) {
    this.fastest = fastest;
    this.acceleration = acceleration;
    this.jerk = jerk;
  }

  /**
   * Plans one.
   *
   * @param length metres, not below 0
   * @param limit metres a second at a distance from the start, above 0; more than the fastest
   *     counts as that
   */
  public VelocityProfile plan(double length, DoubleUnaryOperator limit) {
    if (length <= 0) {
      return new VelocityProfile(1, new double[] {0}, new double[] {0});
    }
    double window = 2 * acceleration / jerk;
    int pieces = (int) Math.clamp(Math.ceil(length / PIECE), 8, MOST_PIECES);
    double piece = length / pieces;
    double[] limits = new double[pieces + 1];
    Arrays.setAll(limits, i -> Math.min(fastest, limit.applyAsDouble(i * piece)));
    double[] fast = lowered(limits, (int) Math.ceil(fastest * window / piece) + 1);
    passForwardAndBack(fast, piece);
    double step = window / STEPS_OF_WINDOW;
    return averaged(overTime(fast, piece, step), step, length);
  }

  /** The least of those within a distance, by a queue of candidates. */
  private static double[] lowered(double[] limits, int reach) {
    double[] least = new double[limits.length];
    int[] queue = new int[limits.length];
    int head = 0;
    int tail = 0;
    for (int i = 0; i < limits.length + reach; i++) {
      if (i < limits.length) {
        while (tail > head && limits[queue[tail - 1]] >= limits[i]) {
          tail--;
        }
        queue[tail++] = i;
      }
      if (i >= reach) {
        while (queue[head] < i - 2 * reach) {
          head++;
        }
        least[i - reach] = limits[queue[head]];
      }
    }
    return least;
  }

  // v^2 grows by at most 2 a s
  private void passForwardAndBack(double[] speeds, double piece) {
    double growth = 2 * acceleration * piece;
    speeds[0] = 0;
    speeds[speeds.length - 1] = 0;
    for (int i = 1; i < speeds.length; i++) {
      speeds[i] = Math.min(speeds[i], Math.sqrt(speeds[i - 1] * speeds[i - 1] + growth));
    }
    for (int i = speeds.length - 2; i >= 0; i--) {
      speeds[i] = Math.min(speeds[i], Math.sqrt(speeds[i + 1] * speeds[i + 1] + growth));
    }
  }

  /** The distances driven after equal steps of time, at constant acceleration in each piece. */
  private static double[] overTime(double[] speeds, double piece, double step) {
    List<Double> distances = new ArrayList<>();
    double time = 0;
    double next = 0;
    for (int i = 1; i < speeds.length; i++) {
      double duration = 2 * piece / (speeds[i - 1] + speeds[i]);
      double gain = (speeds[i] - speeds[i - 1]) / duration;
      while (next <= time + duration) {
        double passed = next - time;
        distances.add((i - 1) * piece + speeds[i - 1] * passed + gain * passed * passed / 2);
        next += step;
      }
      time += duration;
    }
    return distances.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** The speed averaged over the window: the distance driven in it, divided by its seconds. */
  private static VelocityProfile averaged(double[] driven, double step, double length) {
    int count = driven.length + STEPS_OF_WINDOW + 1;
    double[] speeds = new double[count];
    double window = STEPS_OF_WINDOW * step;
    for (int i = 0; i < count; i++) {
      double now = i < driven.length ? driven[i] : length;
      double before =
          i < STEPS_OF_WINDOW ? 0 : driven[Math.min(driven.length - 1, i - STEPS_OF_WINDOW)];
      speeds[i] = i - STEPS_OF_WINDOW >= driven.length ? 0 : (now - before) / window;
    }
    double[] distances = new double[count];
    for (int i = 1; i < count; i++) {
      distances[i] = distances[i - 1] + (speeds[i - 1] + speeds[i]) / 2 * step;
    }
    double scale = length / distances[count - 1];
    for (int i = 0; i < count; i++) { // by rounding only
      distances[i] *= scale;
      speeds[i] *= scale;
    }
    return new VelocityProfile(step, speeds, distances);
  }
}
