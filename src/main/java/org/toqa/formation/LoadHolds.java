package org.toqa.formation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.toqa.geometry.Vec2;

/**
 * Where robots round a load hold it, so that each has the share that it is to have: with shares s
 * and hold points h, the sum of s(i) h(i) is the centre of mass, which is the load's middle. Each
 * holds it on a line from its middle to the edge before the robot, on the edge or under the load:
 * the larger its share, the nearer to the middle.
 *
 * <p>Where the edge points e of robots have their mean near the middle, all are moved by that, as
 * robots reach a little to the side, and so balance with equal weights. Else with h(i) = k(i) e(i)
 * weights w(i) = s(i) k(i) above 0 are asked for with sum w(i) e(i) = 0: those nearest to equal
 * ones, by least squares, and then as large as the edge allows.
 */
public final class LoadHolds {
  private static final double ROUNDING = 1e-9;

  /** Metres that a robot reaches to the side: half of its width. */
  private static final double REACH = 0.13;

  private LoadHolds() {}

  /**
   * @param shape its places round the load
   * @param length of the load, metres
   * @param width of the load, metres
   * @param turn of the load's length from the way that the robots face, radians
   * @param shares by robot, the leader's first, each above 0
   * @return by robot, metres, in the load's frame; empty where robots so placed cannot hold it
   */
  public static Optional<List<Vec2>> of(
      Shape shape, double length, double width, double turn, List<Double> shares) {
    List<Vec2> places = new ArrayList<>(shape.followers());
    places.addFirst(shape.leader());
    List<Vec2> edges =
        centred(
            places.stream().map(place -> edge(place, length, width, turn)).toList(),
            length,
            width,
            turn);
    double[] weights = balancedWeights(edges);
    double scale = Double.POSITIVE_INFINITY;
    for (int i = 0; i < weights.length; i++) {
      if (weights[i] <= ROUNDING) {
        return Optional.empty();
      }
      scale = Math.min(scale, shares.get(i) / weights[i]);
    }
    double most = scale;
    return Optional.of(
        IntStream.range(0, weights.length)
            .mapToObj(i -> edges.get(i).times(most * weights[i] / shares.get(i)))
            .toList());
  }

  /** Moved to where their mean is the middle, if that is not far, and then inward onto the load. */
  private static List<Vec2> centred(List<Vec2> edges, double length, double width, double turn) {
    Vec2 mean = edges.stream().reduce(Vec2.ZERO, Vec2::plus).times(1.0 / edges.size());
    if (mean.norm() > REACH) {
      return edges;
    }
    List<Vec2> moved = edges.stream().map(edge -> edge.minus(mean)).toList();
    double outside =
        moved.stream()
            .map(point -> point.rotated(-turn))
            .mapToDouble(
                seen -> Math.max(2 * Math.abs(seen.x()) / length, 2 * Math.abs(seen.y()) / width))
            .max()
            .orElse(1);
    return moved.stream().map(point -> point.times(1 / Math.max(1, outside))).toList();
  }

  /** The point of the load that is nearest to a place. */
  private static Vec2 edge(Vec2 place, double length, double width, double turn) {
    Vec2 seen = place.rotated(-turn);
    return new Vec2(
            Math.clamp(seen.x(), -length / 2, length / 2),
            Math.clamp(seen.y(), -width / 2, width / 2))
        .rotated(turn);
  }

  /** Of all w with sum w(i) e(i) = 0 the one nearest to 1: w = 1 - E' (E E')^-1 E 1. */
  private static double[] balancedWeights(List<Vec2> edges) {
    double xx = 0;
    double xy = 0;
    double yy = 0;
    Vec2 sum = Vec2.ZERO;
    for (Vec2 edge : edges) {
      xx += edge.x() * edge.x();
      xy += edge.x() * edge.y();
      yy += edge.y() * edge.y();
      sum = sum.plus(edge);
    }
    double determinant = xx * yy - xy * xy;
    Vec2 multiplier =
        determinant > ROUNDING * (xx + yy) * (xx + yy)
            ? new Vec2(
                (yy * sum.x() - xy * sum.y()) / determinant,
                (xx * sum.y() - xy * sum.x()) / determinant)
            : sum.times(1 / (xx + yy)); // all on one line through the middle
    return edges.stream()
        .mapToDouble(edge -> 1 - edge.x() * multiplier.x() - edge.y() * multiplier.y())
        .toArray();
  }
}
