package org.toqa.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;

/** A line through points, metres. */
public final class Polyline {
  private static final double MILLIMETRES = 1_000;

  private Polyline() {}

  /**
   * The positions of as few points as show the line: nowhere further from it than the tolerance.
   * Points are left out one after the other as long as that holds, so it takes time in proportion
   * to the points, times how many are left out in a row.
   *
   * @param isKept which ones stay in any case, by their position; the first and the last do too
   * @param tolerance metres
   */
  public static List<Integer> simplify(List<Vec2> line, IntPredicate isKept, double tolerance) {
    List<Integer> kept = new ArrayList<>();
    int lastKept = 0;
    for (int i = 0; i < line.size(); i++) {
      boolean isEnd = i == 0 || i == line.size() - 1 || isKept.test(i);
      if (isEnd || !isStraight(line, lastKept, i + 1, tolerance)) {
        kept.add(i);
        lastKept = i;
      }
    }
    return kept;
  }

  private static boolean isStraight(List<Vec2> line, int from, int to, double tolerance) {
    for (int i = from + 1; i < to; i++) {
      if (line.get(i).distanceToLine(line.get(from), line.get(to)) > tolerance) {
        return false;
      }
    }
    return true;
  }

  /** The point in whole millimetres. */
  public static Vec2 toMillimetres(Vec2 point) {
    return new Vec2(rounded(point.x()), rounded(point.y()));
  }

  private static double rounded(double metres) {
    return Math.round(metres * MILLIMETRES) / MILLIMETRES;
  }
}
