package org.toqa.sim;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.toqa.geometry.Vec2;

/**
 * What each support of a rigid load bears: statics. The forces s at points p, seen from the centre
 * of mass, balance the weight W: sum s = W, sum s p = 0. More than three points leave that open,
 * and two or points in a row cannot balance what is beside their line; so it is said like this: a
 * support is as stiff as the share k that it is set for, which makes s = k (a + b . p), of all that
 * balance the ones nearest to k: those with the least sum of (s - k)^2 / k. Of what cannot be
 * balanced as much is as possible, by least squares. A support that would have to pull bears
 * nothing, and the others bear its part.
 */
final class SupportForces {
  private static final double ROUNDING = 1e-9;

  private SupportForces() {}

  /**
   * @param points of the supports, metres, from the load's centre of mass
   * @param planned kilograms that each is set for, above 0
   * @param weight kilograms
   * @return by support, kilograms, 0 or more; their sum is the weight
   */
  static double[] of(List<Vec2> points, List<Double> planned, double weight) {
    double[] forces = new double[points.size()];
    int[] bearing = IntStream.range(0, points.size()).toArray();
    while (bearing.length > 0) {
      double[] borne = balance(points, planned, weight, bearing);
      int[] tried = bearing;
      int[] pushing =
          IntStream.range(0, tried.length).filter(i -> borne[i] > 0).map(i -> tried[i]).toArray();
      if (pushing.length == bearing.length) {
        for (int i = 0; i < bearing.length; i++) {
          forces[bearing[i]] = borne[i];
        }
        return forces;
      }
      bearing = pushing;
    }
    return forces;
  }

  /** With c the middle of the points by their k: s = k (W / K + b . (p - c)), M b = -W c. */
  private static double[] balance(
      List<Vec2> points, List<Double> planned, double weight, int[] bearing) {
    double sum = Arrays.stream(bearing).mapToDouble(planned::get).sum();
    Vec2 middle = Vec2.ZERO;
    for (int i : bearing) {
      middle = middle.plus(points.get(i).times(planned.get(i) / sum));
    }
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (int i : bearing) {
      Vec2 from = points.get(i).minus(middle);
      xx += planned.get(i) * from.x() * from.x();
      xy += planned.get(i) * from.x() * from.y();
      yy += planned.get(i) * from.y() * from.y();
    }
    Vec2 slope = slope(xx, xy, yy, middle.times(-weight));
    double[] forces = new double[bearing.length];
    for (int i = 0; i < bearing.length; i++) {
      Vec2 from = points.get(bearing[i]).minus(middle);
      double tilt = slope.x() * from.x() + slope.y() * from.y();
      forces[i] = planned.get(bearing[i]) * (weight / sum + tilt);
    }
    return forces;
  }

  /** The least b with M b nearest to the moment. */
  private static Vec2 slope(double xx, double xy, double yy, Vec2 moment) {
    double determinant = xx * yy - xy * xy;
    double trace = xx + yy;
    if (determinant > ROUNDING * trace * trace) {
      return new Vec2(
          (yy * moment.x() - xy * moment.y()) / determinant,
          (xx * moment.y() - xy * moment.x()) / determinant);
    }
    return trace == 0
        ? Vec2.ZERO
        : new Vec2(xx * moment.x() + xy * moment.y(), xy * moment.x() + yy * moment.y())
            .times(1 / (trace * trace)); // a row of points: M is m u u', its pseudo-inverse M / m^2
  }
}
