package org.toqa.lab.csm;

import org.toqa.geometry.PlaneCurve;
import org.toqa.geometry.Vec2;

/**
 * A curve of the paper: y as a polynomial of x, both in centimetres, driven from one x to a larger
 * one. The parameter is x in decimetres from the start.
 *
 * @param coefficients of x^0, x^1, ... as they are printed
 * @param from centimetres
 * @param to centimetres
 */
record PublishedCurve(double[] coefficients, double from, double to) implements PlaneCurve {
  /** Equation 9: robot 1 in the static environment. */
  static final PublishedCurve EQUATION_9 =
      new PublishedCurve(new double[] {17.02, -0.1923, 0.02534, -0.0001718, 3.622e-7}, 20, 225);

  /** Equation 10: the detour of robot 1. */
  static final PublishedCurve EQUATION_10 =
      new PublishedCurve(new double[] {599.99, -6.7316, 0.024}, 120, 180);

  /** Equation 13: the detour of robot 2. */
  static final PublishedCurve EQUATION_13 =
      new PublishedCurve(new double[] {-357.68, 8.5524, -0.0346}, 103, 174);

  /** Equation 14: robot 3 in the static environment. */
  static final PublishedCurve EQUATION_14 =
      new PublishedCurve(new double[] {157.53, -0.64, 0.0034}, 10, 210);

  private static final double CENTIMETRES_OF_UNIT = 10;
  private static final int PIECES = 2000;

  /** The same between other x. */
  PublishedCurve between(double first, double last) {
    return new PublishedCurve(coefficients, first, last);
  }

  /** y at an x, or a derivative of it by x; centimetres. */
  private double value(double x, int derivative) {
    double sum = 0;
    for (int power = coefficients.length - 1; power >= derivative; power--) {
      double factor = coefficients[power];
      for (int i = 0; i < derivative; i++) {
        factor *= power - i;
      }
      sum = sum * x + factor;
    }
    return sum;
  }

  /** y at an x, both in centimetres. */
  double y(double x) {
    return value(x, 0);
  }

  /** Centimetres along it. */
  double length() {
    double length = 0;
    double step = (to - from) / PIECES;
    for (int i = 0; i < PIECES; i++) {
      double x = from + i * step;
      length += Math.hypot(step, y(x + step) - y(x));
    }
    return length;
  }

  @Override
  public double end() {
    return (to - from) / CENTIMETRES_OF_UNIT;
  }

  private double x(double u) {
    return from + CENTIMETRES_OF_UNIT * u;
  }

  @Override
  public Vec2 position(double u) {
    return new Vec2(x(u), y(x(u))).times(0.01);
  }

  @Override
  public Vec2 velocity(double u) {
    return new Vec2(1, value(x(u), 1)).times(0.01 * CENTIMETRES_OF_UNIT);
  }

  @Override
  public Vec2 acceleration(double u) {
    return new Vec2(0, 0.01 * CENTIMETRES_OF_UNIT * CENTIMETRES_OF_UNIT * value(x(u), 2));
  }
}
