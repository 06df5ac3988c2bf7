package org.toqa.web.api;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * A robot's route with as few points as show it: nowhere further from it than half a centimetre,
 * and in millimetres. So the live events of a large fleet stay small.
 *
 * @param released how many of the points the robot may pass
 */
record DrawnRoute(List<Vec2> points, int released) {
  private static final double TOLERANCE = 0.005;
  private static final double MILLIMETRES = 1_000;

  static DrawnRoute of(List<Vec2> route, int released) {
    List<Vec2> points = new ArrayList<>();
    int passable = 0;
    int kept = 0;
    for (int i = 0; i < route.size(); i++) {
      boolean isEnd = i == 0 || i == route.size() - 1 || i == released - 1;
      if (isEnd || !isStraight(route, kept, i + 1)) {
        points.add(rounded(route.get(i)));
        kept = i;
      }
      if (i == released - 1) {
        passable = points.size();
      }
    }
    return new DrawnRoute(List.copyOf(points), passable);
  }

  private static boolean isStraight(List<Vec2> route, int from, int to) {
    for (int i = from + 1; i < to; i++) {
      if (route.get(i).distanceToLine(route.get(from), route.get(to)) > TOLERANCE) {
        return false;
      }
    }
    return true;
  }

  private static Vec2 rounded(Vec2 point) {
    return new Vec2(rounded(point.x()), rounded(point.y()));
  }

  private static double rounded(double metres) {
    return Math.round(metres * MILLIMETRES) / MILLIMETRES;
  }
}
