package org.toqa.fleet.history;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Polyline;
import org.toqa.geometry.Vec2;

/**
 * The path that a robot had ahead, for as long as it was that one; the robot went along it
 * meanwhile.
 *
 * @param from when it was planned
 * @param until the first moment after it; null: it still is
 * @param points metres, map frame, to the millimetre; where the robot was at first, to its goal
 */
public record PlannedPath(
    String robot, String floor, Instant from, @Nullable Instant until, List<Vec2> points) {

  /** Metres. */
  private static final double TOLERANCE = 0.02;

  public PlannedPath {
    points = List.copyOf(points);
  }

  PlannedPath endedAt(Instant end) {
    return new PlannedPath(robot, floor, from, end, points);
  }

  /**
   * Whether the rest of a path is the rest of this one.
   *
   * @param rest to the millimetre; the first point is where the robot is
   */
  boolean endsWith(List<Vec2> rest) {
    int ahead = rest.size() - 1;
    return ahead <= points.size()
        && rest.subList(1, rest.size())
            .equals(points.subList(points.size() - ahead, points.size()));
  }

  /** The same with as few points as show it. */
  public PlannedPath simplified() {
    List<Vec2> kept =
        Polyline.simplify(points, i -> false, TOLERANCE).stream().map(points::get).toList();
    return new PlannedPath(robot, floor, from, until, kept);
  }
}
