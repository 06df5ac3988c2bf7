package org.toqa.planning.smooth.curve;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * Splines driven one after the other; where one ends and the next begins, the robot turns on the
 * spot. Mostly there is one; more only where no curve without a stop fits.
 *
 * @param pieces each begins where the one before ends; none where start and goal are the same
 */
public record SmoothCurve(List<CubicSpline> pieces) {
  private static final int SAMPLES_OF_SPAN = 16;

  public SmoothCurve {
    pieces = List.copyOf(pieces);
  }

  /** Radians a metre: the largest of 16 points a span; turns on the spot are not counted. */
  public double maxCurvature() {
    double most = 0;
    for (CubicSpline piece : pieces) {
      for (int i = 0; i <= piece.spans() * SAMPLES_OF_SPAN; i++) {
        most = Math.max(most, Math.abs(piece.curvature((double) i / SAMPLES_OF_SPAN)));
      }
    }
    return most;
  }

  /** Metres along it, by chords of a sixteenth of a span. */
  public double length() {
    double length = 0;
    for (CubicSpline piece : pieces) {
      Vec2 before = piece.position(0);
      for (int i = 1; i <= piece.spans() * SAMPLES_OF_SPAN; i++) {
        Vec2 point = piece.position((double) i / SAMPLES_OF_SPAN);
        length += before.distanceTo(point);
        before = point;
      }
    }
    return length;
  }

  /**
   * Points on it, from its start to its end.
   *
   * @param apart metres that neighbours are apart at most
   */
  public List<Vec2> points(double apart) {
    List<Vec2> points = new ArrayList<>();
    for (CubicSpline piece : pieces) {
      for (int span = 0; span < piece.spans(); span++) {
        addPoints(points, piece, span, apart);
      }
      points.add(piece.position(piece.end()));
    }
    return points;
  }

  private static void addPoints(List<Vec2> points, CubicSpline piece, int span, double apart) {
    // the speed of a span is at most that of its control polygon
    double longest = 0;
    for (int i = 0; i < 3; i++) {
      longest =
          Math.max(
              longest,
              piece.controls().get(span + i).distanceTo(piece.controls().get(span + i + 1)));
    }
    int count = (int) Math.max(1, Math.ceil(longest / apart));
    for (int i = 0; i < count; i++) {
      points.add(piece.position(span + (double) i / count));
    }
  }
}
