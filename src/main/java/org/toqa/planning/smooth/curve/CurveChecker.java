package org.toqa.planning.smooth.curve;

import org.toqa.geometry.PlaneCurve;
import org.toqa.geometry.Vec2;
import org.toqa.planning.smooth.DiscSpace;

/**
 * Whether a disc may go along a curve. A piece of it is nowhere farther from its chord than h^2 / 8
 * times the largest second derivative across it, h being its span of the parameter. So a piece is
 * free if its chord is free for a disc that is larger by that, and is halved if not, down to pieces
 * that are straight but for a tenth of a nanometre. Nothing is sampled.
 */
final class CurveChecker {
  /** Metres: pieces that are as straight as this are taken for their chords. */
  private static final double STRAIGHT = 1e-10;

  private final DiscSpace space;

  CurveChecker(DiscSpace space) {
    this.space = space;
  }

  /**
   * Bounds how large a curve's second derivative across a chord is on its span of the parameter;
   * where the curve does not go forward along the chord all the time, the whole derivative.
   */
  interface Bound {
    double of(double begin, double end, Vec2 chord);
  }

  boolean isFree(CubicSpline spline) {
    for (int span = 0; span < spline.spans(); span++) {
      int index = span;
      Bound bound = (begin, end, chord) -> spline.mostAcross(index, begin, end, chord);
      Vec2 from = spline.position(span);
      Vec2 to = spline.position(span + 1.0);
      if (!isFree(spline, span, span + 1.0, from, to, bound)) {
        return false;
      }
    }
    return true;
  }

  boolean isFree(PlaneCurve curve, Bound bound) {
    return isFree(curve, 0, curve.end(), curve.position(0), curve.position(curve.end()), bound);
  }

  private boolean isFree(
      PlaneCurve curve, double begin, double end, Vec2 from, Vec2 to, Bound bound) {
    double span = end - begin;
    double deviation = span * span / 8 * bound.of(begin, end, to.minus(from));
    if (deviation <= STRAIGHT) {
      return space.isFree(from, to);
    }
    if (space.isFree(from, to, deviation)) {
      return true;
    }
    double middle = (begin + end) / 2;
    Vec2 between = curve.position(middle);
    return space.isFree(between)
        && isFree(curve, begin, middle, from, between, bound)
        && isFree(curve, middle, end, between, to, bound);
  }
}
