package org.toqa.motion;

import java.util.Arrays;
import org.toqa.geometry.PlaneCurve;

/** The parameter of a curve by the metres along it. */
public final class ArcLength {
  /** Pieces of a unit of the parameter. */
  private static final int PIECES = 16;

  private final PlaneCurve curve;

  /** Metres up to each end of a piece. */
  private final double[] passed;

  private final double step;

  public ArcLength(PlaneCurve curve) {
    this.curve = curve;
    int pieces = (int) Math.max(1, Math.ceil(curve.end() * PIECES));
    step = curve.end() / pieces;
    passed = new double[pieces + 1];
    for (int i = 0; i < pieces; i++) {
      passed[i + 1] = passed[i] + length(i * step, step);
    }
  }

  /** By Simpson's rule. */
  private double length(double from, double span) {
    return span
        / 6
        * (curve.velocity(from).norm()
            + 4 * curve.velocity(from + span / 2).norm()
            + curve.velocity(from + span).norm());
  }

  /** The whole curve, metres. */
  public double total() {
    return passed[passed.length - 1];
  }

  /**
   * The parameter after so many metres.
   *
   * @param metres from the start; outside the curve its nearer end counts
   */
  public double parameterAt(double metres) {
    double at = Math.clamp(metres, 0, total());
    int found = Arrays.binarySearch(passed, at);
    int piece = Math.clamp(found >= 0 ? found : -found - 2L, 0, passed.length - 2);
    double length = passed[piece + 1] - passed[piece];
    return step * (piece + (length == 0 ? 0 : (at - passed[piece]) / length));
  }
}
