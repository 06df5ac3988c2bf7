package org.toqa.planning.smooth.curve;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.toqa.geometry.Vec2;
import org.toqa.planning.smooth.DiscSpace;

/**
 * Fits the polynomial y(x) of degree 2 to 4 of CSM-MAMRS to a path, by least squares, with start
 * and goal kept. It is refused where the path is no function of x, and where it would touch a wall:
 * a fit knows nothing of walls.
 */
public final class PolynomialFitter {
  private static final int LOWEST = 2;
  private static final int HIGHEST = 4;
  private static final int SAMPLES = 200;

  private final CurveChecker checker;

  /**
   * @param space of the disc that shall drive the curve
   */
  public PolynomialFitter(DiscSpace space) {
    this.checker = new CurveChecker(space);
  }

  /**
   * The polynomial of the lowest degree that is free; nothing where there is none.
   *
   * @param path metres, map frame
   */
  public Optional<PolynomialCurve> fit(List<Vec2> path) {
    if (!isFunctionOfX(path)) {
      return Optional.empty();
    }
    for (int degree = LOWEST; degree <= HIGHEST; degree++) {
      PolynomialCurve curve = fit(path, degree - 1);
      if (checker.isFree(curve, (begin, end, chord) -> curve.mostAcceleration(begin, end))) {
        return Optional.of(curve);
      }
    }
    return Optional.empty();
  }

  private static boolean isFunctionOfX(List<Vec2> path) {
    double direction = Math.signum(path.getLast().x() - path.getFirst().x());
    for (int i = 1; i < path.size(); i++) {
      if ((path.get(i).x() - path.get(i - 1).x()) * direction <= 0) {
        return false;
      }
    }
    return path.size() >= 2;
  }

  /** The normal equations of the terms t (1 - t) t^k. */
  private static PolynomialCurve fit(List<Vec2> path, int terms) {
    double[][] equations = new double[terms][terms + 1];
    Vec2 from = path.getFirst();
    Vec2 to = path.getLast();
    int leg = 1;
    for (int i = 1; i < SAMPLES; i++) {
      double t = (double) i / SAMPLES;
      double along = t * Math.abs(to.x() - from.x());
      while (leg + 1 < path.size() && Math.abs(path.get(leg).x() - from.x()) < along) {
        leg++;
      }
      Vec2 a = path.get(leg - 1);
      Vec2 b = path.get(leg);
      double share = (along - Math.abs(a.x() - from.x())) / Math.abs(b.x() - a.x());
      double above = a.y() + share * (b.y() - a.y()) - from.y() - t * (to.y() - from.y());
      for (int row = 0; row < terms; row++) {
        double term = t * (1 - t) * Math.pow(t, row);
        for (int column = 0; column < terms; column++) {
          equations[row][column] += term * t * (1 - t) * Math.pow(t, column);
        }
        equations[row][terms] += term * above;
      }
    }
    return new PolynomialCurve(from, to, solve(equations));
  }

  /** By Gauss's elimination; the matrix is positive definite. */
  private static List<Double> solve(double[][] equations) {
    int size = equations.length;
    for (int pivot = 0; pivot < size; pivot++) {
      for (int row = pivot + 1; row < size; row++) {
        double factor = equations[row][pivot] / equations[pivot][pivot];
        for (int column = pivot; column <= size; column++) {
          equations[row][column] -= factor * equations[pivot][column];
        }
      }
    }
    double[] solution = new double[size];
    for (int row = size - 1; row >= 0; row--) {
      double rest = equations[row][size];
      for (int column = row + 1; column < size; column++) {
        rest -= equations[row][column] * solution[column];
      }
      solution[row] = rest / equations[row][row];
    }
    List<Double> coefficients = new ArrayList<>();
    for (double c : solution) {
      coefficients.add(c);
    }
    return coefficients;
  }
}
