package org.toqa.web.api;

import java.util.List;
import org.toqa.geometry.Polyline;
import org.toqa.geometry.Vec2;

/**
 * A robot's route with as few points as show it: nowhere further from it than half a centimetre,
 * and in millimetres. So the live events of a large fleet stay small.
 *
 * @param released how many of the points the robot may pass
 */
record SimplifiedPath(List<Vec2> points, int released) {
  private static final double TOLERANCE = 0.005;

  static SimplifiedPath of(List<Vec2> path, int released) {
    List<Integer> kept = Polyline.simplify(path, i -> i == released - 1, TOLERANCE);
    return new SimplifiedPath(
        kept.stream().map(path::get).map(Polyline::toMillimetres).toList(),
        kept.indexOf(released - 1) + 1);
  }
}
