package org.toqa.planning.smooth.curve;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.PlaneCurve;
import org.toqa.geometry.Vec2;

/**
 * A uniform cubic B-spline (de Boor, "A practical guide to splines", 1978): its first and second
 * derivatives are continuous. Each span lies in the hull of four control points that follow each
 * other, and is straight where these are on a line.
 *
 * @param controls metres, map frame, at least four; span i goes by controls i to i + 3
 */
public record CubicSpline(List<Vec2> controls) implements PlaneCurve {

  /**
   * @throws IllegalArgumentException if there are less than four control points
   */
  public CubicSpline {
    controls = List.copyOf(controls);
    if (controls.size() < 4) {
      throw new IllegalArgumentException(
          "A cubic spline has at least four control points, not " + controls.size() + ".");
    }
  }

  /**
   * The spline that begins and ends in the first and last of some points, without curvature there,
   * toward the second and the last but one.
   *
   * @param points metres, at least two
   */
  public static CubicSpline through(List<Vec2> points) {
    List<Vec2> controls = new ArrayList<>();
    controls.add(points.getFirst().times(2).minus(points.get(1)));
    controls.addAll(points);
    controls.add(points.getLast().times(2).minus(points.get(points.size() - 2)));
    return new CubicSpline(controls);
  }

  /** The same curve from its end to its beginning. */
  public CubicSpline reversed() {
    return new CubicSpline(controls.reversed());
  }

  /** How many spans it has: one for each whole number up to the last parameter. */
  public int spans() {
    return controls.size() - 3;
  }

  @Override
  public double end() {
    return spans();
  }

  @Override
  public Vec2 position(double u) {
    int span = span(u);
    double t = u - span;
    double s = 1 - t;
    // B = (1-t)^3/6, (3t^3 - 6t^2 + 4)/6, (-3t^3 + 3t^2 + 3t + 1)/6, t^3/6
    return sum(
        span,
        s * s * s / 6,
        (3 * t * t * t - 6 * t * t + 4) / 6,
        (3 * s * s * s - 6 * s * s + 4) / 6,
        t * t * t / 6);
  }

  @Override
  public Vec2 velocity(double u) {
    int span = span(u);
    double t = u - span;
    double s = 1 - t;
    return sum(span, -s * s / 2, (3 * t * t - 4 * t) / 2, (-3 * s * s + 4 * s) / 2, t * t / 2);
  }

  @Override
  public Vec2 acceleration(double u) {
    int span = span(u);
    double t = u - span;
    return sum(span, 1 - t, 3 * t - 2, 1 - 3 * t, t);
  }

  private int span(double u) {
    return (int) Math.clamp(Math.floor(u), 0, spans() - 1.0);
  }

  private Vec2 sum(int span, double a, double b, double c, double d) {
    Vec2 p = controls.get(span);
    Vec2 q = controls.get(span + 1);
    Vec2 r = controls.get(span + 2);
    Vec2 s = controls.get(span + 3);
    return new Vec2(
        a * p.x() + b * q.x() + c * r.x() + d * s.x(),
        a * p.y() + b * q.y() + c * r.y() + d * s.y());
  }

  /**
   * A bound of the second derivative's size across a chord, between two parameters of a span: it is
   * linear, so that at an end. Where the span may go back along the chord, that of its whole size.
   */
  double mostAcross(int span, double begin, double end, Vec2 chord) {
    if (!isForward(span, chord)) {
      return Math.max(acceleration(span).norm(), sum(span, 0, 1, -2, 1).norm());
    }
    return Math.max(across(acceleration(begin), chord), across(acceleration(end), chord));
  }

  /** The velocity is a mean of the steps between control points. */
  private boolean isForward(int span, Vec2 chord) {
    for (int i = span; i < span + 3; i++) {
      Vec2 step = controls.get(i + 1).minus(controls.get(i));
      if (!(step.x() * chord.x() + step.y() * chord.y() > 0)) {
        return false;
      }
    }
    return true;
  }

  private static double across(Vec2 acceleration, Vec2 chord) {
    double cross = acceleration.x() * chord.y() - acceleration.y() * chord.x();
    return Math.abs(cross) / chord.norm();
  }
}
