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
record SimplifiedPath(List<Vec2> points, int released) {
  private static final double TOLERANCE = 0.005;
  private static final double MILLIMETRES = 1_000;

  static SimplifiedPath of(List<Vec2> path, int released) {
    List<Vec2> points = new ArrayList<>();
    int releasedPoints = 0;
    int lastKept = 0;
    for (int i = 0; i < path.size(); i++) {
      boolean isEnd = i == 0 || i == path.size() - 1 || i == released - 1;
      if (isEnd || !isStraight(path, lastKept, i + 1)) {
        points.add(rounded(path.get(i)));
        lastKept = i;
      }
      if (i == released - 1) {
        releasedPoints = points.size();
      }
    }
    return new SimplifiedPath(List.copyOf(points), releasedPoints);
  }

  private static boolean isStraight(List<Vec2> path, int from, int to) {
    for (int i = from + 1; i < to; i++) {
      if (path.get(i).distanceToLine(path.get(from), path.get(to)) > TOLERANCE) {
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
