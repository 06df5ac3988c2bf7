package org.toqa.planning.smooth.curve;

import java.util.List;
import org.toqa.geometry.PlaneCurve;
import org.toqa.geometry.Vec2;

/**
 * A curve y(x) that is a polynomial, as CSM-MAMRS fits it, with a parameter from 0 at its start to
 * 1 at its end.
 *
 * @param from metres, map frame
 * @param to metres, map frame
 * @param bulge c0, c1, ... in y = line + t (1 - t) (c0 + c1 t + c2 t^2), t = (x - x0) / (x1 - x0)
 */
public record PolynomialCurve(Vec2 from, Vec2 to, List<Double> bulge) implements PlaneCurve {

  public PolynomialCurve {
    bulge = List.copyOf(bulge);
  }

  /** Of y as a polynomial of x. */
  public int degree() {
    return bulge.size() + 1;
  }

  @Override
  public double end() {
    return 1;
  }

  private double c(int index) {
    return index >= 0 && index < bulge.size() ? bulge.get(index) : 0;
  }

  @Override
  public Vec2 position(double u) {
    return new Vec2(
        from.x() + u * (to.x() - from.x()),
        from.y() + u * (to.y() - from.y()) + u * (1 - u) * (c(0) + u * (c(1) + u * c(2))));
  }

  // t (1 - t) (c0 + c1 t + c2 t^2) = c0 t + (c1 - c0) t^2 + (c2 - c1) t^3 - c2 t^4
  @Override
  public Vec2 velocity(double u) {
    double slope = c(0) + u * (2 * (c(1) - c(0)) + u * (3 * (c(2) - c(1)) - u * 4 * c(2)));
    return new Vec2(to.x() - from.x(), to.y() - from.y() + slope);
  }

  @Override
  public Vec2 acceleration(double u) {
    return new Vec2(0, 2 * (c(1) - c(0)) + u * (6 * (c(2) - c(1)) - u * 12 * c(2)));
  }

  /** A bound of the second derivative's size on a span of the parameter. */
  double mostAcceleration(double begin, double end) {
    // a parabola is nowhere farther from its chord than h^2 / 8 times its second derivative
    double span = end - begin;
    return Math.max(Math.abs(acceleration(begin).y()), Math.abs(acceleration(end).y()))
        + span * span / 8 * 24 * Math.abs(c(2));
  }
}
